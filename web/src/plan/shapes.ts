// Connections between elements, and the poses through which edits lead them.
import type { Change, Drawing, Drive, Edit } from '../api/client'
import type { Point } from '../canvas/camera'
import type { Samples } from './samples'

/** Where the robot is led through: its turning point and its heading. */
export interface Pose extends Point {
  heading: number
}
/** A connection from one element to the next: its number in the drive, and its samples. */
export interface Trip {
  index: number
  from: string
  to: string
  first: number
  last: number
}

const drivesUp = 3 // Motion "connect" (openapi.json, plan/samples)

/** All connections from one element to another; those within an area are its fill's own. */
export function tripsOf(drawing: Drawing | null, drive: Drive | null, samples: Samples): Trip[] {
  if (!drawing || !drive) return []
  const trips: Trip[] = []
  drive.connections.forEach((connection, index) => {
    const [a, b] = [drive.strokes[connection.from], drive.strokes[connection.to]]
    if (!a || !b) return // to the first stroke, or to the exit: no two elements
    if (a.element === b.element || a.last < 0 || b.first < 0) return
    let first = a.last
    while (first < b.first && samples.motion[first] !== drivesUp) first++
    let last = b.first
    while (last > first && samples.motion[last - 1] !== drivesUp) last--
    if (last > first) trips.push({ index, from: drawing.elements[a.element].id, to: drawing.elements[b.element].id, first, last })
  })
  return trips
}

type ThroughEdit = Extract<Edit, { edit: 'through' }>
const about = (edits: Edit[], from: string, to: string): ThroughEdit | undefined =>
  edits.find(
    (e): e is ThroughEdit => e.edit === 'through' && ((e.from === from && e.to === to) || (e.from === to && e.to === from)),
  )

/** The poses that hold for it, in driving order. */
export function posesOf(edits: Edit[], from: string, to: string): Pose[] {
  const edit = about(edits, from, to)
  if (!edit) return []
  const poses = edit.poses.map(([x, y, heading]) => ({ x, y, heading }))
  return edit.from === from ? poses : poses.reverse().map((p) => ({ ...p, heading: p.heading + Math.PI }))
}

const rounded = (value: number) => +value.toFixed(4)
export const asRows = (poses: Pose[]): [number, number, number][] =>
  poses.map((p) => [rounded(p.x), rounded(p.y), rounded(Math.atan2(Math.sin(p.heading), Math.cos(p.heading)))])

/** Led through these; without any, as the planner finds it. */
export function shaped(from: string, to: string, poses: Pose[]): Change {
  const edit = { edit: 'through' as const, from, to, poses: asRows(poses) }
  return poses.length > 0 ? { edit } : { drop: { ...edit, poses: [[0, 0, 0]] } }
}

/** What keeps the two one after the other where they meet now; null where a node has no name. */
export function tieOf(trip: Trip, drawing: Drawing, drive: Drive): Change | null {
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
