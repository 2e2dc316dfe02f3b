import type { Stroke } from '../canvas/gestures'
import { palette } from '../canvas/palette'
import { allPlaces, nearestPlace } from '../plan/nodes'
import type { Place } from '../plan/nodes'
import { edit, session } from '../session'
import { metres, press, Tool } from './tool'

/** A place that the drive begins or ends near. */
abstract class DriveEndTool extends Tool {
  abstract override readonly name: 'start' | 'end'
  private at: Stroke | null = null
  hint(): string {
    return `${press()} where the drive is to ${this.name === 'start' ? 'begin' : 'end'}: the nearest suitable node is taken.`
  }
  hover(at: Stroke): void {
    this.at = at
    this.stage.refresh()
  }
  up(at: Stroke): void {
    const { x, y } = at.world
    void edit(`${this.name} near ${x.toFixed(2)}, ${y.toFixed(2)}`, [
      { set: `tour.has_${this.name}`, value: 'on' },
      { set: `tour.${this.name}_x`, value: metres(x) },
      { set: `tour.${this.name}_y`, value: metres(y) },
    ])
  }
  reset(): void {
    this.at = null
    this.say()
  }
  paint(ctx: CanvasRenderingContext2D): void {
    if (this.at) this.dot(ctx, this.at.world, 9, palette[this.name])
  }
}

export class StartTool extends DriveEndTool {
  readonly name = 'start'
}
export class EndTool extends DriveEndTool {
  readonly name = 'end'
}

/** Where a closed line is entered, and an open one begun. */
export class EntryTool extends Tool {
  readonly name = 'entry'
  private under: Place | null = null
  hint(): string {
    return this.under
      ? `${press()}: ${this.under.element} is entered here.`
      : `${press()} a node: there its line is entered. Closed lines have many, open ones their two ends.`
  }
  private places(): Place[] {
    const { drawing, drive, samples } = session.now
    return allPlaces(drawing, drive, samples).filter((place) => {
      const element = drawing?.elements.find((e) => e.id === place.element)
      return element?.kind === 'line'
    })
  }
  hover(at: Stroke): void {
    this.under = nearestPlace(this.places(), at.world, 1.6 * at.reach)
    this.say()
  }
  up(at: Stroke): void {
    this.hover(at)
    if (!this.under) return
    const { element, node } = this.under
    void edit(`enter ${element} at node ${node}`, [{ edit: { edit: 'entry', at: [element, node] } }])
  }
  reset(): void {
    this.under = null
    this.say()
  }
  paint(ctx: CanvasRenderingContext2D): void {
    for (const place of this.places()) this.dot(ctx, place, 4.5, 'rgba(255,255,255,.9)', palette.start)
    if (this.under) this.dot(ctx, this.under, 8, palette.start)
  }
}
