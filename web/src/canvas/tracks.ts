// The plan's runs as lines that can be painted: one Path2D a polyline, made when first needed and culled by its box.
import type { Drive } from '../api/client'
import type { Kept, Samples } from '../plan/samples'
import { emptyBox, include } from './camera'
import type { Box } from './camera'

export interface Track {
  path: Path2D
  box: Box
}
export interface Run {
  first: number
  last: number
  mask: number
  stroke: number
  draws: boolean
}

/** Offset of each pin of a mask from the bar's middle, metres to the left; the highest bit is the leftmost. */
export function pinOffsets(mask: number, pins: number, pitch: number): number[] {
  const offsets: number[] = []
  for (let i = 0; i < pins; i++) if (mask & (1 << i)) offsets.push((i - (pins - 1) / 2) * pitch)
  return offsets
}

/** Metres that nobody sees at that scale: under a pixel, a power of two, so that few levels are kept. */
export const detailAt = (scale: number) => 2 ** Math.floor(Math.log2(0.9 / scale))

/** Of a pixel: a line that leaves out points is nowhere further off. */
const tolerance = 0.5

/** Track of the point of the bar that is `offset` left of its middle, to a share of `detail`. */
export function barTrack(s: Samples, first: number, last: number, offset: number, detail: number): Track {
  const { rakeX, rakeY, heading } = s
  const line = new Line(tolerance * detail)
  if (offset === 0) for (let i = first; i <= last; i++) line.add(rakeX[i], rakeY[i])
  else
    for (let i = first; i <= last; i++)
      line.add(rakeX[i] - offset * Math.sin(heading[i]), rakeY[i] + offset * Math.cos(heading[i]))
  return line.finished()
}

/**
 * A polyline that leaves points out as long as a straight line from the last one kept passes all of them within the
 * tolerance: the directions that do are a cone, which each point narrows (Williams 1978; Zhao and Saalfeld 1997). O(n).
 */
class Line {
  private readonly path = new Path2D()
  private readonly box = emptyBox()
  private count = 0
  /** The last point kept, the last one seen, and the cone's sides. */
  private ax = 0
  private ay = 0
  private x = 0
  private y = 0
  private far = 0
  private open = true
  private leftX = 0
  private leftY = 0
  private rightX = 0
  private rightY = 0
  constructor(private readonly within: number) {}

  add(x: number, y: number): void {
    include(this.box, x, y)
    if (this.count++ === 0) {
      this.path.moveTo(x, y)
      this.begin(x, y)
    } else if (!this.narrow(x, y)) {
      this.path.lineTo(this.x, this.y)
      this.begin(this.x, this.y)
      this.narrow(x, y)
    }
    this.x = x
    this.y = y
  }
  private begin(x: number, y: number): void {
    this.ax = x
    this.ay = y
    this.far = 0
    this.open = true
  }
  /** False: no straight line from the last point kept passes this one too, or the line turns back. */
  private narrow(x: number, y: number): boolean {
    const dx = x - this.ax
    const dy = y - this.ay
    const d = Math.hypot(dx, dy)
    if (d <= this.within && this.open) return true
    if (d < this.far - this.within) return false
    if (!this.open && (dx * this.leftY - dy * this.leftX < 0 || dx * this.rightY - dy * this.rightX > 0)) return false
    if (d > this.far) this.far = d
    const sine = Math.min(1, this.within / d)
    const cosine = Math.sqrt(1 - sine * sine)
    const lx = (dx * cosine - dy * sine) / d
    const ly = (dx * sine + dy * cosine) / d
    const rx = (dx * cosine + dy * sine) / d
    const ry = (dy * cosine - dx * sine) / d
    if (this.open || lx * this.leftY - ly * this.leftX > 0) [this.leftX, this.leftY] = [lx, ly]
    if (this.open || rx * this.rightY - ry * this.rightX < 0) [this.rightX, this.rightY] = [rx, ry]
    this.open = false
    return true
  }
  finished(): Track {
    if (this.count > 1) this.path.lineTo(this.x, this.y)
    return { path: this.path, box: this.box }
  }
}

/** Track of a point of the robot's body, ahead and left of the turning point. */
export function bodyTrack(s: Samples, first: number, last: number, ahead: number, left: number): Track {
  const path = new Path2D()
  const box = emptyBox()
  for (let i = first; i <= last; i += i + 3 < last ? 3 : 1) {
    const c = Math.cos(s.heading[i])
    const n = Math.sin(s.heading[i])
    const x = s.x[i] + ahead * c - left * n
    const y = s.y[i] + ahead * n + left * c
    include(box, x, y)
    if (i === first) path.moveTo(x, y)
    else path.lineTo(x, y)
  }
  return { path, box }
}

const mostLevels = 4

function level<T>(levels: Map<number, (T | undefined)[]>, detail: number): (T | undefined)[] {
  let kept = levels.get(detail)
  if (!kept) {
    if (levels.size >= mostLevels) levels.delete(levels.keys().next().value!)
    levels.set(detail, (kept = []))
  }
  return kept
}

export class Tracks {
  readonly runs: Run[]
  readonly pins: number
  readonly pitch: number
  private middles = new Map<number, (Track | undefined)[]>()
  private grooves = new Map<number, (Track[] | undefined)[]>()
  private wheels: Track[] | undefined

  /** `before`: the tracks of the plan before, for what is driven as it was. */
  constructor(
    readonly samples: Samples,
    readonly drive: Drive,
    before: Tracks | null = null,
  ) {
    this.runs = drive.runs.map(([first, last, mask, stroke, draws]) => ({ first, last, mask, stroke, draws: draws === 1 }))
    this.pins = drive.robot.pins
    this.pitch = drive.robot.pin_pitch
    if (before && samples.kept?.before === before.samples.tag && before.pitch === this.pitch && before.pins === this.pins)
      this.takeOver(before, before.runsAmong(this.runs, samples.kept))
  }

  /** For each of these runs which of this plan's it is, moved to another place; -1: none of them. */
  private runsAmong(runs: Run[], kept: Kept): Int32Array {
    const same = new Int32Array(runs.length).fill(-1)
    let range = 0
    let mine = 0
    runs.forEach(({ first, last, mask }, i) => {
      while (range < kept.to.length && kept.to[range] + kept.count[range] <= last) range++
      if (range === kept.to.length || kept.to[range] > first) return
      const moved = kept.from[range] - kept.to[range]
      if (this.runs[mine]?.first !== first + moved) mine = this.runAt(first + moved)
      const run = this.runs[mine]
      if (run.first === first + moved && run.last === last + moved && run.mask === mask) same[i] = mine++
    })
    return same
  }
  private takeOver(before: Tracks, same: Int32Array): void {
    const moved = <T>(levels: Map<number, (T | undefined)[]>) =>
      new Map([...levels].map(([detail, tracks]) => [detail, Array.from(same, (run) => (run < 0 ? undefined : tracks[run]))]))
    this.middles = moved(before.middles)
    this.grooves = moved(before.grooves)
  }

  /** Track of the rake's middle. */
  middle(run: number, detail: number): Track {
    const { first, last } = this.runs[run]
    return (level(this.middles, detail)[run] ??= barTrack(this.samples, first, last, 0, detail))
  }
  /** Track of each pin that is down. */
  pinTracks(run: number, detail: number): Track[] {
    const { first, last, mask } = this.runs[run]
    const track = (offset: number) => barTrack(this.samples, first, last, offset, detail)
    return (level(this.grooves, detail)[run] ??= pinOffsets(mask, this.pins, this.pitch).map(track))
  }
  /** Tracks of all wheels, run by run. */
  wheelTracks(): Track[] {
    this.wheels ??= this.runs.flatMap(({ first, last }) =>
      this.drive.robot.wheels.map(([ahead, left]) => bodyTrack(this.samples, first, last, ahead, left)),
    )
    return this.wheels
  }
  runAt(sample: number): number {
    let low = 0
    let high = this.runs.length - 1
    while (low < high) {
      const middle = (low + high + 1) >> 1
      if (this.runs[middle].first <= sample) low = middle
      else high = middle - 1
    }
    return low
  }
}
