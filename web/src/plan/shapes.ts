// Connections between elements, and the poses through which edits lead them.
import type { Change, Drawing, Drive, Edit } from '../api/client'
import type { Point } from '../canvas/camera'
import type { Samples } from './samples'

/** Where the robot is led through: its turning point and its heading. */
export interface Pose extends Point {
  heading: number
}
/** What leads from one element to the next, or (a hop) from place to place within an area. */
export interface Led {
  from: string
  to: string
  hop?: number[]
}
/** Its number in the drive, and its samples. */
export interface Trip extends Led {
  index: number
  first: number
  last: number
}

/** As many as the server takes (openapi.json, ThroughEdit). */
export const mostPoses = 200
const drivesUp = 3 // Motion "connect" (openapi.json, plan/samples)

const sameHop = (a?: number[], b?: number[]) => (a && b ? a.every((value, i) => Math.abs(value - b[i]) < 1e-4) : a === b)
/** The same one, driven that way. */
export const same = (a: Led, b: Led) => a.from === b.from && a.to === b.to && sameHop(a.hop, b.hop)
export const nameOf = (led: Led) => (led.hop ? `a drive within ${led.from}` : `${led.from} to ${led.to}`)

/** All connections from one element to another, and those within areas. */
export function tripsOf(drawing: Drawing | null, drive: Drive | null, samples: Samples): Trip[] {
  if (!drawing || !drive) return []
  const trips: Trip[] = []
  drive.connections.forEach((connection, index) => {
    const [a, b] = [drive.strokes[connection.from], drive.strokes[connection.to]]
    if (!a || !b) return // to the first stroke, or to the exit: no two elements
    if ((a.element === b.element && !connection.hop) || a.last < 0 || b.first < 0) return
    let first = a.last
    while (first < b.first && samples.motion[first] !== drivesUp) first++
    let last = b.first
    while (last > first && samples.motion[last - 1] !== drivesUp) last--
    const { hop } = connection
    if (last > first) trips.push({ index, from: drawing.elements[a.element].id, to: drawing.elements[b.element].id, hop, first, last })
  })
  return trips
}

type ThroughEdit = Extract<Edit, { edit: 'through' }>
const about = (edits: Edit[], led: Led): ThroughEdit | undefined =>
  edits.find((e): e is ThroughEdit => e.edit === 'through' && (same(e, led) || (!led.hop && same(e, { from: led.to, to: led.from }))))

/** The poses that hold for it, in driving order. */
export function posesOf(edits: Edit[], led: Led): Pose[] {
  const edit = about(edits, led)
  if (!edit) return []
  const poses = edit.poses.map(([x, y, heading]) => ({ x, y, heading }))
  return edit.from === led.from ? poses : poses.reverse().map((p) => ({ ...p, heading: p.heading + Math.PI }))
}

const rounded = (value: number) => +value.toFixed(4)
export const asRows = (poses: Pose[]): [number, number, number][] =>
  poses.map((p) => [rounded(p.x), rounded(p.y), rounded(Math.atan2(Math.sin(p.heading), Math.cos(p.heading)))])

/** Led through these; without any, as the planner finds it. */
export function shaped({ from, to, hop }: Led, poses: Pose[]): Change {
  const edit = { edit: 'through' as const, from, to, poses: asRows(poses), ...(hop && { hop }) }
  return poses.length > 0 ? { edit } : { drop: { ...edit, poses: [[0, 0, 0]] } }
}

/** What keeps the two one after the other where they meet now; null where a node has no name. */
export function tieOf(trip: Trip, drawing: Drawing, drive: Drive): Change | null {
  if (trip.hop) return null
  const { from, to } = drive.connections[trip.index]
  const node = (stroke: Drive['strokes'][number], leaves: boolean): number | null => {
    const element = drawing.elements[stroke.element]
    if (element.kind === 'region') return leaves ? -1 : 0
    if (element.closed) return stroke.node >= 0 ? stroke.node : null
    return leaves === stroke.reversed ? 0 : -1
  }
  const [a, b] = [node(drive.strokes[from], true), node(drive.strokes[to], false)]
  return a === null || b === null ? null : { edit: { edit: 'link', a: [trip.from, a], b: [trip.to, b] } }
}
