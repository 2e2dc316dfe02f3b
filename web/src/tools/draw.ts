import type { Stroke } from '../canvas/gestures'
import { distance } from '../canvas/camera'
import type { Point } from '../canvas/camera'
import { palette } from '../canvas/palette'
import { api } from '../api/client'
import { edit, notify, session } from '../session'
import { view } from '../view'
import { metres, press, Tool } from './tool'

type Path = (string | number)[]

/** Elements that are on their way to the server. */
const sending = new Set<string>()

/** A name that no element and no edit has. */
function freshId(word: string): string {
  const taken = new Set([...sending, ...(session.now.drawing?.elements.map((e) => e.id) ?? [])])
  for (const e of session.now.standing?.edits ?? []) if (e.edit === 'draw') taken.add(e.element)
  let number = 1
  while (taken.has(`${word}${number}`)) number++
  return `${word}${number}`
}

/** One element more; gives whether it is kept. */
async function drawn(what: string, element: string, paths: Path[], pins: number, smooth: number): Promise<boolean> {
  sending.add(element)
  const kept = await edit(what, [{ edit: { edit: 'draw', element, paths, pins, smooth } }])
  sending.delete(element)
  return kept
}

/** Pen or finger: the line is smoothed, and closed where its ends meet. */
export class DrawTool extends Tool {
  readonly name = 'draw'
  private points: Point[] = []
  /** Lines that the server has not answered for. */
  private sent: Point[][] = []
  hint(): string {
    return 'Draw with pen, finger or mouse. A line that ends where it began is closed.'
  }
  down(at: Stroke): void {
    this.points = [at.world]
  }
  move(at: Stroke): void {
    const last = this.points[this.points.length - 1]
    if (last && distance(last, at.world) * this.stage.camera.scale > 3) this.points.push(at.world)
    this.stage.refresh()
  }
  up(at: Stroke): void {
    const { points } = this
    this.points = []
    if (points.length < 2) return this.stage.refresh()
    const closed = points.length > 8 && distance(points[0], at.world) < 1.6 * at.reach
    const path: Path = ['M', +metres(points[0].x), +metres(points[0].y)]
    for (const p of points.slice(1)) path.push('L', +metres(p.x), +metres(p.y))
    if (closed) path.push('L', path[1], path[2], 'Z')
    const { pins, smooth } = view.now.pen
    const element = freshId('pen')
    this.sent.push(points)
    void drawn(`draw ${element}`, element, [path], pins, smooth).then((kept) => {
      this.sent = this.sent.filter((line) => line !== points)
      if (!kept) this.stage.refresh() // else when it is planned: it does not flicker
    })
  }
  reset(): void {
    this.points = []
    this.say()
  }
  paint(ctx: CanvasRenderingContext2D): void {
    for (const line of [...this.sent, this.points]) if (line.length > 1) this.line(ctx, line, palette.ink, 2.5)
  }
}

/** Words as single lines, put where the canvas is clicked. */
export class TextTool extends Tool {
  readonly name = 'text'
  private at: Point | null = null
  private size = { width: 0, height: 0, key: '' }
  hint(): string {
    return `Write above, then ${press().toLowerCase()} where the words are to stand (their lower left corner).`
  }
  hover(at: Stroke): void {
    this.at = at.world
    void this.measure()
    this.stage.refresh()
  }
  private async measure(): Promise<void> {
    const wish = view.now.text
    const key = JSON.stringify(wish)
    if (this.size.key === key || !wish.text.trim()) return
    this.size.key = key
    try {
      const { width, height } = await api.lettering(wish)
      this.size = { width, height, key }
      this.stage.refresh()
    } catch (error) {
      notify(error instanceof Error ? error.message : String(error))
    }
  }
  up(at: Stroke): void {
    void this.put(at.world)
  }
  private async put(at: Point): Promise<void> {
    const wish = view.now.text
    if (!wish.text.trim()) return notify('Write some words first.')
    try {
      const { paths, warnings } = await api.lettering(wish)
      for (const warning of warnings) notify(`${warning.place}: ${warning.reason}`)
      const element = freshId('text')
      const moved = paths.map((path) => movedTo(path, at))
      const pins = view.now.pen.pins
      await drawn(`write "${wish.text.slice(0, 24)}"`, element, moved, pins, 0)
    } catch (error) {
      notify(error instanceof Error ? error.message : String(error))
    }
  }
  reset(): void {
    this.at = null
    this.say()
  }
  paint(ctx: CanvasRenderingContext2D): void {
    if (!this.at || this.size.width === 0) return
    const { x, y } = this.at
    const { width: w, height: h } = this.size
    const corners = [
      { x, y },
      { x: x + w, y },
      { x: x + w, y: y + h },
      { x, y: y + h },
      { x, y },
    ]
    this.line(ctx, corners, palette.select, 1.5, [6, 4])
  }
}

/** Hershey letters are straight lines: pairs of numbers behind M and L. */
function movedTo(path: Path, by: Point): Path {
  let even = true
  return path.map((value) => {
    if (typeof value === 'string') return value
    const moved = +metres(value + (even ? by.x : by.y))
    even = !even
    return moved
  })
}
