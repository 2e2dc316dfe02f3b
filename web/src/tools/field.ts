import type { Stroke } from '../canvas/gestures'
import { distance } from '../canvas/camera'
import type { Point } from '../canvas/camera'
import { palette } from '../canvas/palette'
import type { Change } from '../api/client'
import { between, borderSet, boxOf, endDropped, endOf, endSet, fencesOf, gripAt, gripped, keepOutsSet, withoutCorner } from '../plan/fences'
import type { End, Fence, Grip } from '../plan/fences'
import type { Pose } from '../plan/shapes'
import { edit, session } from '../session'
import type { Offer } from '../view'
import { view } from '../view'
import { byKey, press, Tool } from './tool'

const handle = 38 // pixels from a pose to the handle that turns it
const dragged = 6 // pixels

/** What is going on between a press and its end. */
type Act =
  | { kind: 'fence'; grip: Grip; from: Point }
  | { kind: 'pose'; end: End; turns: boolean }
  | { kind: 'new'; from: Point }

const names = { border: 'the border', 'keep-out': 'a keep-out', park: 'where the robot is parked', exit: 'where the drive ends' }
const settings = () => session.now.standing?.settings ?? {}

/** Where the robot may drive and where not; where it is parked, and where it leaves to. */
export class FieldTool extends Tool {
  readonly name = 'field'
  private act: Act | null = null
  private moved = false
  /** What would hold if the hand let go now. */
  private trial: Fence[] | null = null
  private pose: Pose | null = null
  /** Corners put so far. */
  private corners: Point[] = []
  private pointer: Point | null = null

  constructor(...args: ConstructorParameters<typeof Tool>) {
    super(...args)
    view.listen((now, before) => {
      if (now.tool !== 'field' || now.field.what === before.field.what) return
      this.letGo()
      if (now.field.what === 'border') this.stage.fit()
    })
    session.listen((now, before) => {
      if (view.now.tool === 'field' && now.standing !== before.standing) this.stage.refresh()
    })
  }
  hint(): string {
    const { what, corner } = view.now.field
    if (this.corners.length > 2) return `${press()} the next corner; the first one closes it.${byKey('Enter does too; Escape drops it.')}`
    if (this.corners.length > 0) return `${press()} the next corner.${byKey('Escape drops it.')}`
    if (corner) return `Drag the corner to move it.${byKey('Delete takes it out.')} A keep-out is moved by its inside.`
    if (what === 'park' || what === 'exit') return `Press ${names[what]} and drag to where it looks; drag its point or its arrow to change it.`
    return `Drag a box, or ${press().toLowerCase()} corner by corner, for ${names[what]}. Corners, middles of edges and keep-outs can be dragged.`
  }
  override offers(): Offer[] {
    if (this.corners.length > 2) return ['finish', 'cancel']
    if (this.corners.length > 0) return ['cancel']
    return view.now.field.corner ? ['let-go'] : []
  }
  private fences(): Fence[] {
    return this.trial ?? fencesOf(settings(), session.now.drawing)
  }
  private poseOf(end: End): Pose | null {
    return this.act?.kind === 'pose' && this.act.end === end && this.pose ? this.pose : endOf(settings(), end)
  }
  private grip(pose: Pose): Point {
    const reach = handle / this.stage.camera.scale
    return { x: pose.x + reach * Math.cos(pose.heading), y: pose.y + reach * Math.sin(pose.heading) }
  }
  private closes(at: Stroke): boolean {
    return this.corners.length > 2 && distance(this.corners[0], at.world) < 1.6 * at.reach
  }

  hover(at: Stroke): void {
    this.pointer = at.world
    this.stage.refresh()
  }
  down(at: Stroke): void {
    this.pointer = at.world
    this.moved = false
    const { what } = view.now.field
    if (this.corners.length > 0) this.act = { kind: 'new', from: at.world }
    else if (!this.takePose(at) && !this.takeFence(at)) {
      view.set({ field: { ...view.now.field, corner: null } })
      if (what === 'park' || what === 'exit') {
        this.act = { kind: 'pose', end: what, turns: true }
        this.pose = { ...at.world, heading: endOf(settings(), what)?.heading ?? 0 }
        this.moved = true
      } else this.act = { kind: 'new', from: at.world }
    }
    this.say()
  }
  private takePose(at: Stroke): boolean {
    for (const end of ['park', 'exit'] as const) {
      const pose = endOf(settings(), end)
      if (!pose) continue
      const turns = distance(this.grip(pose), at.world) < 1.2 * at.reach
      if (!turns && distance(pose, at.world) > 1.4 * at.reach) continue
      this.act = { kind: 'pose', end, turns }
      this.pose = { ...pose }
      return true
    }
    return false
  }
  private takeFence(at: Stroke): boolean {
    const grip = gripAt(this.fences(), at.world, at.reach)
    if (!grip) return false
    this.act = { kind: 'fence', grip, from: at.world }
    view.set({ field: { ...view.now.field, corner: grip.what === 'corner' ? { fence: grip.fence, corner: grip.corner } : null } })
    return true
  }
  move(at: Stroke): void {
    const { act } = this
    this.pointer = at.world
    if (act?.kind === 'pose' && this.pose) {
      this.moved = true
      if (!act.turns) Object.assign(this.pose, at.world)
      else if (distance(this.pose, at.world) * this.stage.camera.scale > dragged)
        this.pose.heading = Math.atan2(at.world.y - this.pose.y, at.world.x - this.pose.x)
    } else if (act && act.kind !== 'pose') {
      this.moved ||= distance(act.from, at.world) * this.stage.camera.scale > dragged
      const fences = fencesOf(settings(), session.now.drawing)
      if (act.kind === 'fence' && this.moved) this.trial = gripped(fences, act.grip, act.from, at.world)
    }
    this.stage.refresh()
  }
  up(at: Stroke): void {
    const { act, moved, pose, trial } = this
    if (act?.kind === 'pose' && pose && moved) void this.keep(`${names[act.end]}`, endSet(act.end, pose))
    else if (act?.kind === 'fence' && trial) void this.keep(`change ${names[act.grip.fence === 0 ? 'border' : 'keep-out']}`, this.changeOf(trial, act.grip.fence))
    else if (act?.kind === 'new' && moved && this.corners.length === 0) this.draw(boxOf(act.from, at.world))
    else if (act?.kind === 'new' && this.closes(at)) this.finish()
    else if (act?.kind === 'new') this.corners.push(at.world)
    this.act = null
    this.say()
  }
  private changeOf(fences: Fence[], changed: number): Change[] {
    return [changed === 0 ? borderSet(fences[0]) : keepOutsSet(fences.slice(1))]
  }
  /** The corners put so far are all. */
  override finish(): void {
    if (this.corners.length > 2) this.draw(this.corners)
    this.say()
  }
  private draw(fence: Fence): void {
    const { what } = view.now.field
    const fences = fencesOf(settings(), session.now.drawing)
    this.trial = what === 'border' ? [fence, ...fences.slice(1)] : [...fences, fence]
    void this.keep(`draw ${names[what]}`, this.changeOf(this.trial, what === 'border' ? 0 : fences.length))
    this.corners = []
  }
  /** What was dragged stays in sight until the server has it. */
  private async keep(what: string, changes: Change[]): Promise<void> {
    await edit(what, changes)
    if (!this.act) {
      this.trial = this.pose = null
      this.say()
    }
  }
  override erase(): boolean {
    const { corner, what } = view.now.field
    if (!corner && (what === 'park' || what === 'exit') && endOf(settings(), what)) {
      void edit(`without ${names[what]}`, endDropped(settings(), what))
      return true
    }
    if (!corner) return false
    const left = withoutCorner(this.fences(), corner.fence, corner.corner)
    view.set({ field: { ...view.now.field, corner: null } })
    void edit('take a corner out', this.changeOf(left, corner.fence))
    this.say()
    return true
  }
  private letGo(): void {
    this.act = this.trial = this.pose = null
    this.corners = []
    this.say()
  }
  override cancel(): void {
    this.letGo()
  }
  reset(): void {
    view.set({ field: { ...view.now.field, corner: null } })
    this.letGo()
  }

  paint(ctx: CanvasRenderingContext2D): void {
    this.fences().forEach((fence, i) => this.paintFence(ctx, fence, i))
    for (const end of ['park', 'exit'] as const) {
      const pose = this.poseOf(end)
      if (!pose) continue
      const colour = end === 'park' ? palette.start : palette.end
      this.line(ctx, [pose, this.grip(pose)], colour, 2)
      this.dot(ctx, this.grip(pose), 5, '#fff', colour)
      this.dot(ctx, pose, 9, colour)
    }
    const { act, corners, pointer } = this
    if (act?.kind === 'new' && this.moved && corners.length === 0 && pointer) this.ring(ctx, boxOf(act.from, pointer), [6, 4])
    if (corners.length > 0 && pointer) this.line(ctx, [...corners, pointer], palette.keepOutEdge, 2.5, [6, 4])
    for (const p of corners) this.dot(ctx, p, 6, palette.keepOutEdge)
  }
  private paintFence(ctx: CanvasRenderingContext2D, fence: Fence, index: number): void {
    const colour = index === 0 ? palette.fieldEdge : palette.keepOutEdge
    if (this.trial) this.ring(ctx, fence, [], colour)
    const chosen = view.now.field.corner
    fence.forEach((p, corner) => {
      this.dot(ctx, between(p, fence[(corner + 1) % fence.length]), 3.5, 'rgba(255,255,255,.9)', colour)
      const here = chosen?.fence === index && chosen.corner === corner
      this.dot(ctx, p, here ? 8 : 6, here ? palette.hover : colour)
    })
  }
  private ring(ctx: CanvasRenderingContext2D, fence: Fence, dash: number[], colour: string = palette.keepOutEdge): void {
    this.line(ctx, [...fence, fence[0]], colour, 2.5, dash)
  }
}
