// Stacked canvases: below the sand and the drive, drawn when something changed; above them what moves. While the
// view is dragged or zoomed the lower one is a bitmap that is moved along; it is drawn anew when the hand rests.
import type { SessionState } from '../session'
import { session } from '../session'
import { sampleAt } from '../plan/samples'
import type { ViewState } from '../view'
import { view } from '../view'
import { fitted, include, toWorld, visible } from './camera'
import type { Box, Camera, Point } from './camera'
import { drawnByProcessor } from './hardware'
import { Picking } from './picking'
import * as marks from './marks'
import * as paint from './paint'
import { palette } from './palette'
import { Tracks } from './tracks'

const restAfter = 140 // ms without a gesture

export type Overlay = (ctx: CanvasRenderingContext2D, stage: Stage) => void

export class Stage {
  camera: Camera = { scale: 40, x: 60, y: 600 }
  width = 0
  height = 0
  tracks: Tracks | null = null
  shapes: paint.Shapes | null = null
  picking: Picking | null = null
  /** What the tool shows, in pixels. */
  overlay: Overlay | null = null
  /** Milliseconds of the last full drawing, for benches. */
  lastRedraw = 0

  private readonly base: HTMLCanvasElement
  private readonly top: HTMLCanvasElement
  private readonly kept = document.createElement('canvas')
  private keptCamera: Camera | null = null
  private restTimer = 0
  private wanted = { base: false, top: false }
  private fittedOnce = false
  private playedTo = -1

  constructor(readonly host: HTMLElement) {
    const willReadFrequently = drawnByProcessor()
    // A context is what it was when it was first asked for.
    this.kept.getContext('2d', { willReadFrequently })
    const layer = (name: string) => {
      const canvas = document.createElement('canvas')
      canvas.getContext('2d', { alpha: name !== 'base', willReadFrequently })
      canvas.className = `layer ${name}`
      canvas.setAttribute('aria-hidden', 'true')
      host.appendChild(canvas)
      return canvas
    }
    this.base = layer('base')
    this.top = layer('top')
    new ResizeObserver(() => this.resize()).observe(host)
    session.listen((now, before) => this.take(now, before))
    view.listen((now, before) => this.look(now, before))
    this.resize()
    this.take(session.now, null)
  }

  get ratio(): number {
    return Math.min(window.devicePixelRatio || 1, 2)
  }
  get box(): Box {
    return visible(this.camera, this.width, this.height)
  }
  world(p: Point): Point {
    return toWorld(this.camera, p)
  }

  private resize(): void {
    this.width = this.host.clientWidth
    this.height = this.host.clientHeight
    for (const canvas of [this.base, this.top]) {
      canvas.width = Math.max(1, Math.round(this.width * this.ratio))
      canvas.height = Math.max(1, Math.round(this.height * this.ratio))
    }
    if (!this.fittedOnce) this.fit()
    this.redraw()
  }

  /** The canvas with a little around it; for the field tool the border too. */
  fit(): void {
    const drawing = session.now.drawing
    if (!drawing || this.width === 0) return
    this.fittedOnce = true
    const { width, height } = drawing.canvas
    const box = { x0: 0, y0: 0, x1: width, y1: height }
    const { border } = drawing
    const fences = view.now.tool === 'field'
    if (fences) for (let i = 0; i + 1 < border.length; i += 2) include(box, border[i], border[i + 1])
    // Corners are to be taken hold of: not under the hint line.
    this.camera = fitted(box, this.width, this.height, fences ? 84 : 56)
    this.redraw()
  }
  /** A place in the middle, near enough to see it. */
  show(p: Point): void {
    const scale = Math.max(this.camera.scale, 120 / Math.max(0.5, (session.now.drawing?.canvas.width ?? 14) / 14))
    this.camera = { scale, x: this.width / 2 - p.x * scale, y: this.height / 2 + p.y * scale }
    this.redraw()
  }

  private take(now: SessionState, before: SessionState | null): void {
    if (now.drawing !== before?.drawing) {
      this.shapes = now.drawing ? new paint.Shapes(now.drawing) : null
      this.picking = now.drawing ? new Picking(now.drawing) : null
      if (now.drawing?.canvas.width !== before?.drawing?.canvas.width) this.fittedOnce = false
      if (!this.fittedOnce) this.fit()
    }
    if (now.drive !== before?.drive || now.samples !== before?.samples)
      this.tracks = now.drive && now.samples.count > 0 ? new Tracks(now.samples, now.drive, this.tracks) : null
    if (now.drawing !== before?.drawing || now.drive !== before?.drive || now.samples !== before?.samples) this.redraw()
    if (now.report !== before?.report) this.refresh()
  }

  private look(now: ViewState, before: ViewState): void {
    const changed = (...keys: (keyof ViewState)[]) => keys.some((key) => now[key] !== before[key])
    if (changed('look', 'connections', 'orderColours', 'wheels', 'grid')) this.redraw()
    else if (now.time !== before.time) {
      const forward = now.time !== null && before.time !== null && now.time >= before.time && this.playedTo >= 0
      if (forward) this.playOn()
      else this.redraw()
    }
    this.refresh()
  }

  /** The view was moved: what was drawn is moved along until the hand rests. */
  gesture(camera: Camera): void {
    if (!this.keptCamera) {
      this.kept.width = this.base.width
      this.kept.height = this.base.height
      this.kept.getContext('2d')!.drawImage(this.base, 0, 0)
      this.keptCamera = this.camera
    }
    this.camera = camera
    window.clearTimeout(this.restTimer)
    this.restTimer = window.setTimeout(() => this.redraw(), restAfter)
    this.want('base')
  }

  redraw(): void {
    window.clearTimeout(this.restTimer)
    this.keptCamera = null
    this.want('base')
  }
  refresh(): void {
    this.want('top')
  }
  private want(layer: 'base' | 'top'): void {
    const idle = !this.wanted.base && !this.wanted.top
    this.wanted[layer] = true
    if (layer === 'base') this.wanted.top = true
    if (idle) requestAnimationFrame(() => this.frame())
  }
  private frame(): void {
    const { base, top } = this.wanted
    this.wanted = { base: false, top: false }
    if (base) {
      if (this.keptCamera) this.paintMoved()
      else this.paintBase()
    }
    if (top) this.paintTop()
  }

  private paintMoved(): void {
    const ctx = this.base.getContext('2d')!
    const from = this.keptCamera!
    const f = this.camera.scale / from.scale
    paint.inPixels(ctx, 1)
    ctx.fillStyle = palette.around
    ctx.fillRect(0, 0, this.base.width, this.base.height)
    ctx.setTransform(f, 0, 0, f, (this.camera.x - from.x * f) * this.ratio, (this.camera.y - from.y * f) * this.ratio)
    ctx.drawImage(this.kept, 0, 0)
  }

  /** Up to the playback's time; all without it. */
  private get lastSample(): number {
    const { time } = view.now
    const s = session.now.samples
    return time === null ? s.count - 1 : sampleAt(s, time)
  }

  /** Draws everything, at once: also for benches. */
  paintBase(): void {
    const begun = performance.now()
    const ctx = this.base.getContext('2d')!
    const { look, grid } = view.now
    const realistic = look === 'realistic'
    paint.paintSand(ctx, session.now.drawing, this.camera, this.ratio, realistic)
    paint.inMetres(ctx, this.camera, this.ratio)
    const box = this.box
    if (grid && !realistic) paint.paintGrid(ctx, box, this.camera.scale)
    if (this.shapes && !realistic) this.shapes.paint(ctx, box, this.camera.scale, view.now.time !== null || !this.tracks)
    this.playedTo = this.lastSample
    this.paintDrive(ctx, { from: 0, to: this.playedTo })
    this.lastRedraw = performance.now() - begun
  }

  private playOn(): void {
    const to = this.lastSample
    if (this.keptCamera || this.wanted.base || view.now.wheels) return this.redraw()
    if (to > this.playedTo) this.paintDrive(this.base.getContext('2d')!, { from: this.playedTo, to })
    this.playedTo = to
  }

  private paintDrive(ctx: CanvasRenderingContext2D, span: paint.Span): void {
    if (!this.tracks) return
    const { look, connections, orderColours, wheels } = view.now
    const box = this.box
    paint.inMetres(ctx, this.camera, this.ratio)
    if (look === 'realistic') paint.paintGrooves(ctx, this.tracks, box, this.camera, this.ratio, span, orderColours)
    else paint.paintOutline(ctx, this.tracks, box, this.camera, this.ratio, span, orderColours)
    paint.inMetres(ctx, this.camera, this.ratio)
    if (wheels) paint.paintWheels(ctx, this.tracks, box)
    if (connections !== 'hidden')
      paint.paintConnections(ctx, this.tracks, box, this.camera.scale, span, connections === 'arrows')
  }

  private paintTop(): void {
    const ctx = this.top.getContext('2d')!
    ctx.setTransform(1, 0, 0, 1, 0, 0)
    ctx.clearRect(0, 0, this.top.width, this.top.height)
    const { drive, samples, report } = session.now
    this.paintMarked(ctx)
    if (drive && samples.count > 0) {
      paint.inMetres(ctx, this.camera, this.ratio)
      if (view.now.robot) marks.paintRobot(ctx, samples, drive, view.now.time === null ? 0 : this.lastSample, this.camera.scale)
      paint.inPixels(ctx, this.ratio)
      this.paintEnds(ctx)
      const { time } = view.now
      const until = time === null ? null : { time, sample: this.lastSample }
      if (view.now.faults) marks.paintFaults(ctx, report, drive, this.camera, until)
    }
    paint.inPixels(ctx, this.ratio)
    this.overlay?.(ctx, this)
    paint.inPixels(ctx, this.ratio)
    if (view.now.grid) marks.paintRuler(ctx, this.camera, this.width, this.height)
  }

  /** The element that is selected, and the one under the pointer. */
  private paintMarked(ctx: CanvasRenderingContext2D): void {
    const drawing = session.now.drawing
    if (!drawing || !this.shapes) return
    paint.inMetres(ctx, this.camera, this.ratio)
    ctx.lineJoin = ctx.lineCap = 'round'
    for (const [id, style, width] of [
      [view.now.hovered, palette.hover, 3],
      [view.now.selected, palette.select, 4.5],
    ] as const) {
      const index = id ? drawing.elements.findIndex((element) => element.id === id) : -1
      if (index < 0) continue
      ctx.globalAlpha = 0.75
      ctx.strokeStyle = style
      ctx.lineWidth = width / this.camera.scale
      ctx.stroke(this.shapes.tracks[index].path)
      ctx.globalAlpha = 1
    }
  }

  private paintEnds(ctx: CanvasRenderingContext2D): void {
    const s = session.now.samples
    const dot = (i: number, colour: string, letter: string) => {
      const x = this.camera.x + s.rakeX[i] * this.camera.scale
      const y = this.camera.y - s.rakeY[i] * this.camera.scale
      ctx.fillStyle = colour
      ctx.beginPath()
      ctx.arc(x, y, 9, 0, 2 * Math.PI)
      ctx.fill()
      ctx.strokeStyle = '#fff'
      ctx.lineWidth = 1.5
      ctx.stroke()
      ctx.fillStyle = '#fff'
      ctx.font = '600 11px system-ui, sans-serif'
      ctx.textAlign = 'center'
      ctx.textBaseline = 'middle'
      ctx.fillText(letter, x, y + 0.5)
    }
    dot(s.count - 1, palette.end, 'E')
    dot(0, palette.start, 'S')
  }
}
