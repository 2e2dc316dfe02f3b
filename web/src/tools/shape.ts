import { api, Refusal } from '../api/client'
import type { Stroke } from '../canvas/gestures'
import { distance } from '../canvas/camera'
import type { Point } from '../canvas/camera'
import { palette } from '../canvas/palette'
import { asRows, mostPoses, nameOf, posesOf, same, shaped, tieOf, tripsOf } from '../plan/shapes'
import type { Pose, Trip } from '../plan/shapes'
import { edit, notify, projectId, session } from '../session'
import type { Offer } from '../view'
import { view } from '../view'
import { byKey, press, Tool } from './tool'

const handle = 38 // pixels from a point to the handle that turns it

/** What is being dragged: a point, or its heading. */
interface Drag {
  pose: number
  turns: boolean
  /** From the pointer to the point, metres. */
  offset: Point
  moved: boolean
}
/** The curve as it would be, or why it cannot be. */
interface Trial {
  points: Point[]
  refused: string
}

/** Shape connection: it is led through points with headings, which are put in, moved, turned and taken out. */
export class ShapeTool extends Tool {
  readonly name = 'shape'
  private under: Trip | null = null
  private poses: Pose[] = []
  private drag: Drag | null = null
  private trial: Trial | null = null
  private asking = false
  private asked: Pose[] | null = null

  constructor(...args: ConstructorParameters<typeof Tool>) {
    super(...args)
    session.listen((now, before) => {
      if (view.now.tool !== 'shape' || now.drive === before.drive) return
      if (!this.drag) this.trial = null
      this.say()
    })
  }
  hint(): string {
    const { shape } = view.now
    if (!shape) return `${press()} a drive between two elements, or between two places of an area.`
    if (this.trial?.refused) return this.trial.refused
    if (shape.pose >= 0) return `Drag the point to move it, its arrow to turn it.${byKey('Delete takes it out, Escape lets go.')}`
    return `${shape.hop ? `Within ${shape.from}` : `From ${shape.from} to ${shape.to}`}: drag the line where it is to run elsewhere.`
  }
  override offers(): Offer[] {
    return view.now.shape ? ['let-go'] : []
  }
  private trips(): Trip[] {
    const { drawing, drive, samples } = session.now
    return tripsOf(drawing, drive, samples)
  }
  private chosen(): Trip | null {
    const { shape } = view.now
    return (shape && this.trips().find((trip) => same(trip, shape))) ?? null
  }
  /** The poses as they are dragged, else those that hold. */
  private now(): Pose[] {
    const { shape } = view.now
    if (this.drag || this.trial) return this.poses
    return shape ? posesOf(session.now.standing?.edits ?? [], shape) : []
  }
  /** The connection under the pointer, by what the robot or the rake drives, and the sample there. */
  private find(at: Stroke, trips: Trip[]): { trip: Trip; sample: number } | null {
    const { x, y, rakeX, rakeY } = session.now.samples
    let best: { trip: Trip; sample: number } | null = null
    let nearest = 1.6 * at.reach
    for (const trip of trips)
      for (let i = trip.first; i <= trip.last; i++) {
        const robot = Math.hypot(x[i] - at.world.x, y[i] - at.world.y)
        const d = Math.min(robot, 1.3 * Math.hypot(rakeX[i] - at.world.x, rakeY[i] - at.world.y))
        if (d < nearest) [nearest, best] = [d, { trip, sample: i }]
      }
    return best
  }
  private grip(pose: Pose): Point {
    const reach = handle / this.stage.camera.scale
    return { x: pose.x + reach * Math.cos(pose.heading), y: pose.y + reach * Math.sin(pose.heading) }
  }
  hover(at: Stroke): void {
    this.under = this.find(at, this.trips())?.trip ?? null
    this.stage.refresh()
  }
  down(at: Stroke): void {
    const poses = this.now()
    const begin = (pose: number, turns: boolean, place: Point) => {
      this.poses = poses.map((p) => ({ ...p }))
      this.drag = { pose, turns, moved: false, offset: { x: place.x - at.world.x, y: place.y - at.world.y } }
      view.set({ shape: { ...view.now.shape!, pose } })
      this.say()
    }
    const turned = poses.findIndex((p) => distance(this.grip(p), at.world) < 1.2 * at.reach)
    if (turned >= 0) return begin(turned, true, this.grip(poses[turned]))
    const moved = poses.findIndex((p) => distance(p, at.world) < 1.4 * at.reach)
    if (moved >= 0) return begin(moved, false, poses[moved])
    const chosen = this.chosen()
    const found = (chosen && this.find(at, [chosen])) ?? this.find(at, this.trips())
    view.set({ shape: found ? { ...named(found.trip), pose: -1 } : null })
    this.trial = null
    if (found) this.put(found.trip, found.sample, at)
    this.say()
  }
  /** A new point where the line was taken; it counts once it has been dragged. */
  private put(trip: Trip, sample: number, at: Stroke): void {
    const { x, y, heading } = session.now.samples
    const poses = posesOf(session.now.standing?.edits ?? [], trip)
    if (poses.length >= mostPoses) return notify(`${mostPoses} points are the limit: take one out first.`)
    const nearest = (p: Pose) => {
      let best = trip.first
      for (let i = trip.first; i <= trip.last; i++)
        if (Math.hypot(x[i] - p.x, y[i] - p.y) < Math.hypot(x[best] - p.x, y[best] - p.y)) best = i
      return best
    }
    const pose = poses.filter((p) => nearest(p) < sample).length
    const place = { x: x[sample], y: y[sample], heading: heading[sample] }
    this.poses = [...poses.slice(0, pose), place, ...poses.slice(pose)]
    this.drag = { pose, turns: false, moved: false, offset: { x: place.x - at.world.x, y: place.y - at.world.y } }
  }
  move(at: Stroke): void {
    const { drag } = this
    if (!drag) return
    const to = { x: at.world.x + drag.offset.x, y: at.world.y + drag.offset.y }
    const pose = this.poses[drag.pose]
    if (!drag.moved && distance(drag.turns ? this.grip(pose) : pose, to) * this.stage.camera.scale < 4) return
    drag.moved = true
    if (drag.turns) pose.heading = Math.atan2(at.world.y - pose.y, at.world.x - pose.x)
    else Object.assign(pose, to)
    this.attempt()
    this.stage.refresh()
  }
  up(): void {
    const { drag } = this
    const trip = this.chosen()
    this.drag = null
    if (!drag?.moved || !trip) {
      this.trial = null
      return this.say()
    }
    view.set({ shape: { ...named(trip), pose: drag.pose } })
    this.say()
    void this.keep(trip, this.poses)
  }
  private async keep(trip: Trip, poses: Pose[]): Promise<void> {
    const { drawing, drive } = session.now
    const tie = tieOf(trip, drawing!, drive!)
    const taken = await edit(`shape ${nameOf(trip)}`, [shaped(trip, poses), ...(tie ? [tie] : [])])
    if (!taken) this.trial = null
    this.say()
  }
  /** Asks what the curve would be; while an answer is awaited only the newest wish is kept. */
  private attempt(): void {
    this.asked = this.poses.map((p) => ({ ...p }))
    this.trial ??= { points: [], refused: '' }
    if (!this.asking) void this.ask()
  }
  private async ask(): Promise<void> {
    this.asking = true
    while (this.asked && this.chosen()) {
      const poses = asRows(this.asked)
      this.asked = null
      try {
        const { points, length, loops } = await api.connection(projectId(), session.now.planned, this.chosen()!.index, poses)
        const wide = session.now.drive!.robot.min_radius
        const tight = loops ? `Too tight for a least radius of ${wide} m: it has to go round in a loop. ` : ''
        if (this.trial) this.trial = { points: pairs(points), refused: tight && `${tight}${length.toFixed(1)} m.` }
      } catch (error) {
        const why = error instanceof Refusal ? error.message : String(error)
        if (this.trial) this.trial = { points: [], refused: why }
      }
      this.say()
    }
    this.asking = false
  }
  erase(): boolean {
    const { shape } = view.now
    const trip = this.chosen()
    if (!shape || shape.pose < 0 || !trip) return false
    const left = this.now().filter((_, i) => i !== shape.pose)
    view.set({ shape: { ...shape, pose: -1 } })
    this.drag = this.trial = null
    void edit(`take a point out of ${nameOf(trip)}`, [shaped(trip, left)])
    return true
  }
  cancel(): void {
    this.drag = this.trial = null
    this.say()
  }
  reset(): void {
    this.drag = this.trial = this.under = null
    view.set({ shape: null })
    this.say()
  }
  paint(ctx: CanvasRenderingContext2D): void {
    const { x, y } = session.now.samples
    const path = (trip: Trip) => Array.from({ length: trip.last - trip.first + 1 }, (_, i) => ({ x: x[trip.first + i], y: y[trip.first + i] }))
    const trip = this.chosen()
    if (this.under && this.under.index !== trip?.index) this.line(ctx, path(this.under), palette.hover, 2.5)
    if (!trip) return
    const along = this.trial?.points ?? []
    const kept = this.trial !== null && along.length > 0
    const bad = this.trial !== null && this.trial.refused !== ''
    if (!kept) this.line(ctx, path(trip), palette.select, 3, bad ? [3, 6] : [])
    else this.line(ctx, along, bad ? palette.fault : palette.select, 3)
    this.now().forEach((pose, i) => {
      const grip = this.grip(pose)
      const here = i === view.now.shape?.pose
      this.line(ctx, [pose, grip], palette.select, 2)
      this.dot(ctx, grip, 5, '#fff', palette.select)
      this.dot(ctx, pose, here ? 9 : 7, here ? palette.hover : palette.select)
    })
  }
}

const named = ({ from, to, hop }: Trip) => ({ from, to, ...(hop && { hop }) })

function pairs(flat: number[]): Point[] {
  return Array.from({ length: flat.length / 2 }, (_, i) => ({ x: flat[2 * i], y: flat[2 * i + 1] }))
}
