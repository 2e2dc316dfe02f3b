// The plan's runs as lines that can be painted: one Path2D a polyline, made when first needed and culled by its box.
import type { Drive } from '../api/client'
import type { Samples } from '../plan/samples'
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

/**
 * Track of the point of the bar that is `offset` left of its middle. Points that bend it by less than a hair, or are
 * nearer than `detail` to the one before, are left out.
 */
export function barTrack(s: Samples, first: number, last: number, offset: number, detail: number): Track {
  const path = new Path2D()
  const box = emptyBox()
  const turn = 0.01
  const stretch = 0.4
  let keptX = NaN
  let keptY = NaN
  let keptWay = 0
  for (let i = first; i <= last; i++) {
    const x = s.rakeX[i] - offset * Math.sin(s.heading[i])
    const y = s.rakeY[i] + offset * Math.cos(s.heading[i])
    include(box, x, y)
    if (i === first) path.moveTo(x, y)
    else {
      const way = Math.atan2(y - keptY, x - keptX)
      const bend = Math.abs(Math.atan2(Math.sin(way - keptWay), Math.cos(way - keptWay)))
      const far = Math.hypot(x - keptX, y - keptY)
      if (i < last && (far < detail || (i > first + 1 && bend < turn && far < stretch))) continue
      path.lineTo(x, y)
      keptWay = way
    }
    keptX = x
    keptY = y
  }
  return { path, box }
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

  constructor(
    readonly samples: Samples,
    readonly drive: Drive,
  ) {
    this.runs = drive.runs.map(([first, last, mask, stroke, draws]) => ({ first, last, mask, stroke, draws: draws === 1 }))
    this.pins = drive.robot.pins
    this.pitch = drive.robot.pin_pitch
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
