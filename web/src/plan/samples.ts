// The trajectory as columns, made of what the server sends (openapi.json, plan/samples) and of what is there already.
export interface Samples {
  /** Of the content: what the server is told is there. */
  tag: string
  count: number
  t: Float64Array
  x: Float32Array
  y: Float32Array
  heading: Float32Array
  rakeX: Float32Array
  rakeY: Float32Array
  mask: Uint32Array
  stroke: Int32Array
  motion: Uint8Array
  /** Which of them were there before, and where. */
  kept: Kept | null
}
/** Ranges of samples in their order: from `to` on, as many, as they stood from `from` on among those before. */
export interface Kept {
  before: string
  to: Int32Array
  from: Int32Array
  count: Int32Array
}

function bare(tag: string, count: number): Samples {
  const floats = () => new Float32Array(count)
  const [x, y, heading, rakeX, rakeY] = [floats(), floats(), floats(), floats(), floats()]
  const [mask, stroke, motion] = [new Uint32Array(count), new Int32Array(count), new Uint8Array(count)]
  return { tag, count, t: new Float64Array(count), x, y, heading, rakeX, rakeY, mask, stroke, motion, kept: null }
}
export const noSamples: Samples = bare('', 0)

const rangeSize = 24

/** What the server's answer makes of the samples that it was told of. */
export function readSamples(bytes: ArrayBuffer, tag: string, before: Samples): Samples {
  const head = new DataView(bytes)
  if (bytes.byteLength < 16 || head.getUint32(0, false) !== 0x534c5332) throw new Error('these are no samples')
  const [count, ranges, fresh] = [4, 8, 12].map((at) => head.getUint32(at, true))
  let at = 16 + rangeSize * ranges
  const floats = () => new Float32Array(bytes, (at += 4 * fresh) - 4 * fresh, fresh)
  const times = floats()
  const columns = [floats(), floats(), floats(), floats(), floats()]
  const masks = new Uint32Array(bytes, at, fresh)
  const strokes = new Int32Array(bytes, at + 4 * fresh, fresh)
  const motions = new Uint8Array(bytes, at + 8 * fresh, fresh)

  const made = bare(tag, count)
  const { t, stroke, mask, motion } = made
  const into = [made.x, made.y, made.heading, made.rakeX, made.rakeY]
  const old = [before.x, before.y, before.heading, before.rakeX, before.rakeY]
  const kept: [number, number, number][] = []
  let to = 0
  let next = 0 // of the fresh
  for (let k = 0; k < ranges; k++) {
    const place = 16 + rangeSize * k
    const later = head.getFloat64(place, true)
    const further = head.getInt32(place + 8, true)
    const n = head.getUint32(place + 12, true)
    const start = head.getInt32(place + 16, true)
    const [from, source, time, whose] = start < 0 ? [next, columns, times, strokes] : [start, old, before.t, before.stroke]
    const end = from + n
    source.forEach((column, c) => into[c].set(column.subarray(from, end), to))
    mask.set((start < 0 ? masks : before.mask).subarray(from, end), to)
    motion.set((start < 0 ? motions : before.motion).subarray(from, end), to)
    for (let i = from, j = to; i < end; i++, j++) {
      t[j] = time[i] + later
      stroke[j] = whose[i] < 0 ? -1 : whose[i] + further
    }
    if (start < 0) next = end
    else kept.push([to, start, n])
    to += n
  }
  if (kept.length > 0) {
    const column = (i: number) => Int32Array.from(kept, (range) => range[i])
    made.kept = { before: before.tag, to: column(0), from: column(1), count: column(2) }
  }
  return made
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
