// Colours of the canvas. Sand is light: what is drawn on it is dark or saturated.
export const palette = {
  around: '#d9c9a6',
  sand: '#ecdfc4',
  sandDark: '#dccba6',
  edge: '#b39d70',
  field: 'rgba(120, 95, 50, 0.55)',
  fieldEdge: '#7a5f32',
  keepOut: 'rgba(107, 47, 143, 0.22)',
  keepOutEdge: '#6b2f8f',
  grid: 'rgba(110, 85, 45, 0.13)',
  gridStrong: 'rgba(110, 85, 45, 0.26)',
  ink: '#2f2a20',
  area: 'rgba(110, 86, 46, 0.10)',
  areaEdge: 'rgba(90, 68, 32, 0.45)',
  trip: '#c2452d',
  tripSoft: 'rgba(194, 69, 45, 0.55)',
  select: '#0b6e78',
  hover: '#128b97',
  fault: '#b3261e',
  blemish: '#b35c00',
  wheel: 'rgba(70, 74, 92, 0.20)',
  robot: '#1d4b52',
  start: '#1a7f37',
  end: '#7a2e8e',
  grooveFloor: 'rgba(196, 172, 125, 0.92)',
  grooveDark: 'rgba(118, 92, 50, 0.62)',
  grooveLight: 'rgba(255, 250, 235, 0.80)',
}

/** From first to last: blue over green and yellow to red, each dark enough on sand. */
export function orderColour(share: number): string {
  const stops = [
    [43, 75, 155],
    [20, 122, 115],
    [86, 120, 28],
    [176, 98, 10],
    [163, 34, 60],
  ]
  const at = Math.min(0.9999, Math.max(0, share)) * (stops.length - 1)
  const i = Math.floor(at)
  const mixed = stops[i].map((c, k) => Math.round(c + (stops[i + 1][k] - c) * (at - i)))
  return `rgb(${mixed.join(',')})`
}

/** Grains, the same on every machine. */
export function sandTile(): HTMLCanvasElement {
  const size = 192
  const tile = document.createElement('canvas')
  tile.width = tile.height = size
  const ctx = tile.getContext('2d')!
  const image = ctx.createImageData(size, size)
  let seed = 12345
  for (let i = 0; i < image.data.length; i += 4) {
    seed = (Math.imul(seed, 1103515245) + 12345) >>> 0
    const grain = (seed >>> 16) / 65535
    const dark = grain < 0.5
    image.data[i] = dark ? 120 : 255
    image.data[i + 1] = dark ? 92 : 250
    image.data[i + 2] = dark ? 48 : 232
    image.data[i + 3] = grain < 0.06 || grain > 0.94 ? 44 : 16 * Math.abs(grain - 0.5) * 2
  }
  ctx.putImageData(image, 0, 0)
  return tile
}
