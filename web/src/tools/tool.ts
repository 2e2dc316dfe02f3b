// A tool is a few states with one edit at the end. Escape takes it back to its first state.
import type { Hand, Stroke } from '../canvas/gestures'
import type { Stage } from '../canvas/stage'
import type { Point } from '../canvas/camera'
import { toScreen } from '../canvas/camera'
import { session } from '../session'
import type { Offer, ToolName } from '../view'
import { view } from '../view'
import { palette } from '../canvas/palette'

/** Fingers tap and have no keys: what keys do is beside the hint as buttons. */
const byFinger = matchMedia('(pointer: coarse)')
export const press = () => (byFinger.matches ? 'Tap' : 'Click')
export const byKey = (sentence: string) => (byFinger.matches ? '' : ` ${sentence}`)

export abstract class Tool implements Hand {
  abstract readonly name: ToolName
  constructor(protected readonly stage: Stage) {}
  /** What to do next, for the hint line. */
  abstract hint(): string
  /** What can be done now with what was begun or chosen, other than on the canvas. */
  offers(): Offer[] {
    return []
  }
  down(_at: Stroke): void {}
  move(_at: Stroke): void {}
  up(_at: Stroke): void {}
  hover(_at: Stroke): void {}
  cancel(): void {
    this.reset()
  }
  /** Takes out what the tool has chosen. False: it has chosen nothing. */
  erase(): boolean {
    return false
  }
  /** What was begun is complete: Enter. */
  finish(): void {}
  /** Back to the first state. */
  reset(): void {}
  paint(_ctx: CanvasRenderingContext2D): void {}

  protected say(): void {
    view.set({ hint: this.hint(), offers: this.offers() })
    this.stage.refresh()
  }
  protected elementAt(at: Stroke, areasOnly = false): string {
    const { picking } = this.stage
    const index = areasOnly ? picking?.areaAt(at.world) : picking?.element(at.world, at.reach)
    return index === undefined || index < 0 ? '' : (session.now.drawing?.elements[index].id ?? '')
  }
  protected screen(p: Point): Point {
    return toScreen(this.stage.camera, p)
  }
  protected dot(ctx: CanvasRenderingContext2D, p: Point, radius: number, fill: string, line: string = '#fff'): void {
    const at = this.screen(p)
    ctx.beginPath()
    ctx.arc(at.x, at.y, radius, 0, 2 * Math.PI)
    ctx.fillStyle = fill
    ctx.fill()
    ctx.lineWidth = 1.5
    ctx.strokeStyle = line
    ctx.stroke()
  }
  protected line(ctx: CanvasRenderingContext2D, points: Point[], style: string = palette.select, width = 2, dash: number[] = []): void {
    ctx.beginPath()
    points.forEach((p, i) => {
      const at = this.screen(p)
      if (i === 0) ctx.moveTo(at.x, at.y)
      else ctx.lineTo(at.x, at.y)
    })
    ctx.setLineDash(dash)
    ctx.strokeStyle = style
    ctx.lineWidth = width
    ctx.lineJoin = ctx.lineCap = 'round'
    ctx.stroke()
    ctx.setLineDash([])
  }
}

export const metres = (value: number) => `${+value.toFixed(3)}`
