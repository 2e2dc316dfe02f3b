import type { Change } from '../api/client'
import type { Stroke } from '../canvas/gestures'
import { distance } from '../canvas/camera'
import type { Point } from '../canvas/camera'
import { palette } from '../canvas/palette'
import { edit, session } from '../session'
import { view } from '../view'
import { metres, press, Tool } from './tool'

const hint = (element: string, name: string, value: string): Change => ({ edit: { edit: 'hint', element, name, value } })
const asked = (element: string, name: string): string =>
  session.now.drawing?.elements.find((e) => e.id === element)?.hints[name] ?? ''

/** How an area is filled: a click sets the style, a drag the direction of its lines; for the area, or one segment of it. */
export class FillTool extends Tool {
  readonly name = 'fill'
  private element = ''
  private from: Point | null = null
  private to: Point | null = null

  hint(): string {
    if (this.from) return `Let go: lines of ${this.element} run that way.`
    const what = view.now.fill.whole ? 'an area' : 'a segment of an area'
    return `${press()} ${what} to fill it in the style chosen above; drag inside it to give its lines a direction.`
  }
  hover(at: Stroke): void {
    view.set({ hovered: this.elementAt(at, true) })
  }
  down(at: Stroke): void {
    this.element = this.elementAt(at, true)
    this.from = this.to = this.element ? at.world : null
    view.set({ selected: this.element })
    this.say()
  }
  move(at: Stroke): void {
    if (this.from) this.to = at.world
    this.stage.refresh()
  }
  up(at: Stroke): void {
    const { element, from } = this
    this.reset()
    if (!from) return
    const dragged = distance(from, at.world) * this.stage.camera.scale > 12
    const way = Math.atan2(at.world.y - from.y, at.world.x - from.x)
    const degrees = `${Math.round((way * 180) / Math.PI)}deg`
    const style = dragged ? 'zigzag' : view.now.fill.style
    if (view.now.fill.whole) {
      const turned = [hint(element, 'fill-best-direction', 'off'), hint(element, 'fill-direction', degrees)]
      void edit(`fill ${element}`, [hint(element, 'fill-style', style), ...(dragged ? turned : [])])
    } else {
      const choice = `${metres(from.x)},${metres(from.y)} ${dragged ? `direction=${degrees}` : `style=${style}`}`
      const before = asked(element, 'fill-segments')
      void edit(`fill a segment of ${element}`, [
        hint(element, 'fill-style', 'zigzag'),
        hint(element, 'fill-segments', before ? `${before}; ${choice}` : choice),
      ])
    }
  }
  reset(): void {
    this.from = this.to = null
    this.element = ''
    this.say()
  }
  paint(ctx: CanvasRenderingContext2D): void {
    if (!this.from || !this.to) return
    this.line(ctx, [this.from, this.to], palette.select, 3)
    this.dot(ctx, this.from, 5, palette.select)
    this.dot(ctx, this.to, 7, palette.select)
  }
}

/** Parts an area by a line: it is segmented anew. */
export class CutTool extends Tool {
  readonly name = 'cut'
  private element = ''
  private points: Point[] = []
  hint(): string {
    return this.points.length > 0
      ? 'Let go beyond the area: it is parted along this line.'
      : 'Drag a line across an area: its zigzag is parted there, each side with lines of its own direction.'
  }
  hover(at: Stroke): void {
    view.set({ hovered: this.elementAt(at, true) })
  }
  down(at: Stroke): void {
    this.element = this.elementAt(at, true)
    this.points = [at.world, at.world]
    this.say()
  }
  move(at: Stroke): void {
    this.element ||= this.elementAt(at, true)
    this.points = [this.points[0], at.world]
    this.stage.refresh()
  }
  up(at: Stroke): void {
    const { element } = this
    const [a] = this.points
    this.reset()
    if (!element || !a || distance(a, at.world) * this.stage.camera.scale < 12) return
    const cut = `${metres(a.x)},${metres(a.y)} ${metres(at.world.x)},${metres(at.world.y)}`
    const before = asked(element, 'fill-cuts')
    void edit(`cut ${element}`, [
      hint(element, 'fill-style', 'zigzag'),
      hint(element, 'fill-cuts', before ? `${before}; ${cut}` : cut),
    ])
  }
  reset(): void {
    this.points = []
    this.element = ''
    this.say()
  }
  paint(ctx: CanvasRenderingContext2D): void {
    if (this.points.length > 1) this.line(ctx, this.points, palette.fault, 2.5, [8, 5])
  }
}
