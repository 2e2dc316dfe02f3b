// The trajectory as columns, as the server sends it (openapi.json, plan/samples).
export interface Samples {
  count: number
  t: Float32Array
  x: Float32Array
  y: Float32Array
  heading: Float32Array
  rakeX: Float32Array
  rakeY: Float32Array
  mask: Uint32Array
  stroke: Int32Array
  motion: Uint8Array
}

export const noSamples: Samples = readSamples(new Uint8Array([83, 76, 83, 49, 0, 0, 0, 0]).buffer)

export function readSamples(bytes: ArrayBuffer): Samples {
  const head = new DataView(bytes)
  if (bytes.byteLength < 8 || head.getUint32(0, false) !== 0x534c5331) throw new Error('these are no samples')
  const count = head.getUint32(4, true)
  let at = 8
  const floats = () => new Float32Array(bytes, (at += 4 * count) - 4 * count, count)
  const [t, x, y, heading, rakeX, rakeY] = [floats(), floats(), floats(), floats(), floats(), floats()]
  const mask = new Uint32Array(bytes, at, count)
  const stroke = new Int32Array(bytes, at + 4 * count, count)
  const motion = new Uint8Array(bytes, at + 8 * count, count)
  return { count, t, x, y, heading, rakeX, rakeY, mask, stroke, motion }
}

/** Index of the last sample that is not after `time`. */
export function sampleAt(samples: Samples, time: number): number {
  let low = 0
  let high = samples.count - 1
  while (low < high) {
    const middle = (low + high + 1) >> 1
    if (samples.t[middle] <= time) low = middle
    else high = middle - 1
  }
  return low
}
