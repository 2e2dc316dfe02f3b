// The field's border, the keep-outs that are set by hand, and where the robot is parked and leaves: settings <-> places.
import type { Change, Drawing, Standing } from '../api/client'
import { distance } from '../canvas/camera'
import type { Point } from '../canvas/camera'
import { inside } from '../canvas/picking'
import type { Pose } from './shapes'

export type Settings = Standing['settings']
/** Corners of the border (the first fence there is), or of a keep-out. */
export type Fence = Point[]
export type End = 'park' | 'exit'
/** A corner, the middle of the edge behind it, or what a fence encloses. */
export interface Grip {
  what: 'corner' | 'edge' | 'inside'
  fence: number
  corner: number
}

const keys = { park: ['park.x', 'park.y', 'park.heading'], exit: ['park.exit_x', 'park.exit_y', 'park.exit_heading'] }
const rounded = (metres: number) => `${+metres.toFixed(4)}`
const pairs = (flat: number[]): Point[] =>
  Array.from({ length: flat.length >> 1 }, (_, i) => ({ x: flat[2 * i], y: flat[2 * i + 1] }))
const numbers = (text: string) => text.split(/[\s,]+/).filter(Boolean).map(Number)
const text = (fence: Fence) => fence.map((p) => `${rounded(p.x)},${rounded(p.y)}`).join(' ')

/** The border first: as set, else the one that holds; then the keep-outs that are set. Those of the drawing stay where they are drawn. */
export function fencesOf(settings: Settings, drawing: Drawing | null): Fence[] {
  const border = settings['field.border'] ?? ''
  const keepOuts = (settings['field.keep_out'] ?? '').split(';').map((outline) => pairs(numbers(outline)))
  return [pairs(border ? numbers(border) : (drawing?.border ?? [])), ...keepOuts.filter((fence) => fence.length > 0)]
}
/** Under three corners a keep-out is gone, and the border is what it is by default. */
export function borderSet(fence: Fence): Change {
  return { set: 'field.border', value: fence.length < 3 ? '' : text(fence) }
}
export function keepOutsSet(fences: Fence[]): Change {
  return { set: 'field.keep_out', value: fences.filter((fence) => fence.length > 2).map(text).join('; ') }
}

export const between = (a: Point, b: Point): Point => ({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 })

/** What of the fences is taken at a place: corners go before edges, those before what is enclosed (by keep-outs). */
export function gripAt(fences: Fence[], at: Point, reach: number): Grip | null {
  let best: Grip | null = null
  for (const what of ['corner', 'edge'] as const) {
    let nearest = what === 'corner' ? 1.4 * reach : reach
    fences.forEach((points, fence) =>
      points.forEach((p, corner) => {
        const place = what === 'corner' ? p : between(p, points[(corner + 1) % points.length])
        const d = distance(place, at)
        if (d < nearest) [nearest, best] = [d, { what, fence, corner }]
      }),
    )
    if (best) return best
  }
  for (let fence = fences.length - 1; fence > 0; fence--)
    if (inside(fences[fence].flatMap((p) => [p.x, p.y]), at)) return { what: 'inside', fence, corner: -1 }
  return null
}

/** Fences with what is gripped moved to, or by, somewhere. An edge gets a corner there. */
export function gripped(fences: Fence[], grip: Grip, from: Point, to: Point): Fence[] {
  const { what, fence, corner } = grip
  return fences.map((points, i) => {
    if (i !== fence) return points
    if (what === 'inside') return points.map((p) => ({ x: p.x + to.x - from.x, y: p.y + to.y - from.y }))
    if (what === 'edge') return [...points.slice(0, corner + 1), to, ...points.slice(corner + 1)]
    return points.map((p, k) => (k === corner ? to : p))
  })
}
export function withoutCorner(fences: Fence[], fence: number, corner: number): Fence[] {
  return fences.map((points, i) => (i === fence ? points.filter((_, k) => k !== corner) : points))
}
export const boxOf = (a: Point, b: Point): Fence => [a, { x: b.x, y: a.y }, b, { x: a.x, y: b.y }]

const radians = (angle: string) => (angle.endsWith('rad') ? parseFloat(angle) : (parseFloat(angle) * Math.PI) / 180)

/** Where the robot is parked, or where it is to end; null: nowhere of its own. */
export function endOf(settings: Settings, end: End): Pose | null {
  if (end === 'park' ? settings['park.parked'] !== 'on' : settings['park.exit'] !== 'pose') return null
  const [x, y, heading] = keys[end].map((key) => settings[key] ?? '0')
  return { x: parseFloat(x), y: parseFloat(y), heading: radians(heading) }
}
export function endSet(end: End, pose: Pose): Change[] {
  const values = [rounded(pose.x), rounded(pose.y), `${+((pose.heading * 180) / Math.PI).toFixed(1)}deg`]
  const wanted: Change = end === 'park' ? { set: 'park.parked', value: 'on' } : { set: 'park.exit', value: 'pose' }
  return [wanted, ...keys[end].map((key, i) => ({ set: key, value: values[i] }))]
}
/** Without a pose of its own; what the drive ends with otherwise is said for the exit. A place to go back to is gone with it. */
export function endDropped(settings: Settings, end: End, exit = ''): Change[] {
  const gone = keys[end].map((key) => ({ set: key, value: '' }))
  if (end === 'exit') return [...gone, { set: 'park.exit', value: exit }]
  const back = settings['park.exit'] === 'parked' ? [{ set: 'park.exit', value: '' }] : []
  return [...gone, { set: 'park.parked', value: '' }, ...back]
}
