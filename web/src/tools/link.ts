import type { Stroke } from '../canvas/gestures'
import type { Point } from '../canvas/camera'
import { palette } from '../canvas/palette'
import { allPlaces, nearestPlace } from '../plan/nodes'
import type { Place } from '../plan/nodes'
import { edit, session } from '../session'
import type { Offer } from '../view'
import { byKey, press, Tool } from './tool'

/** Change connection: from a node to a node of another element. What is possible is shown; the new one replaces the old. */
export class LinkTool extends Tool {
  readonly name = 'link'
  private from: Place | null = null
  private under: Place | null = null
  private pointer: Point | null = null
  private dragged = false

  hint(): string {
    if (!this.from) return `${press()} the node where an element is left.`
    return `From ${this.from.element}: ${press().toLowerCase()} the node where the next element is entered.${byKey('Escape starts over.')}`
  }
  override offers(): Offer[] {
    return this.from ? ['cancel'] : []
  }
  private places(): Place[] {
    const { drawing, drive, samples } = session.now
    const all = allPlaces(drawing, drive, samples)
    return this.from ? all.filter((place) => place.element !== this.from!.element) : all
  }
  hover(at: Stroke): void {
    this.pointer = at.world
    this.under = nearestPlace(this.places(), at.world, 1.6 * at.reach)
    this.stage.refresh()
  }
  down(at: Stroke): void {
    this.hover(at)
    this.dragged = false
    if (!this.under) return
    if (!this.from) {
      this.from = this.under
      this.under = null
    } else void this.tie(this.from, this.under)
    this.say()
  }
  move(at: Stroke): void {
    this.dragged = true
    this.hover(at)
  }
  up(at: Stroke): void {
    this.hover(at)
    if (this.dragged && this.from && this.under) void this.tie(this.from, this.under)
    this.say()
  }
  private async tie(a: Place, b: Place): Promise<void> {
    this.reset()
    await edit(`connect ${a.element} to ${b.element}`, [
      { edit: { edit: 'link', a: [a.element, a.node], b: [b.element, b.node] } },
    ])
  }
  reset(): void {
    this.from = this.under = null
    this.say()
  }
  paint(ctx: CanvasRenderingContext2D): void {
    for (const place of this.places()) this.dot(ctx, place, 4.5, 'rgba(255,255,255,.9)', palette.select)
    if (this.from && this.pointer) this.line(ctx, [this.from, this.under ?? this.pointer], palette.select, 2.5, [7, 5])
    if (this.under) this.dot(ctx, this.under, 8, palette.hover)
    if (this.from) this.dot(ctx, this.from, 8, palette.select)
  }
}
