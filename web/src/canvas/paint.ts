// Painters: each draws one thing onto a context whose units are metres, y up.
import type { Drawing } from '../api/client'
import { grown, overlaps } from './camera'
import type { Box, Camera, Point } from './camera'
import { orderColour, palette, sandTile } from './palette'
import type { Run, Track, Tracks } from './tracks'
import { barTrack, detailAt, pinOffsets } from './tracks'

export type Ctx = CanvasRenderingContext2D

let grains: CanvasPattern | null = null

export function inMetres(ctx: Ctx, camera: Camera, ratio: number): void {
  ctx.setTransform(camera.scale * ratio, 0, 0, -camera.scale * ratio, camera.x * ratio, camera.y * ratio)
}
export function inPixels(ctx: Ctx, ratio: number): void {
  ctx.setTransform(ratio, 0, 0, ratio, 0, 0)
}

export function paintSand(ctx: Ctx, drawing: Drawing | null, camera: Camera, ratio: number, realistic: boolean): void {
  inPixels(ctx, 1)
  ctx.fillStyle = palette.around
  ctx.fillRect(0, 0, ctx.canvas.width, ctx.canvas.height)
  if (!drawing) return
  const { width, height } = drawing.canvas
  inMetres(ctx, camera, ratio)
  ctx.fillStyle = palette.sand
  ctx.fillRect(0, 0, width, height)
  if (realistic) {
    grains ??= ctx.createPattern(sandTile(), 'repeat')
    ctx.save()
    ctx.beginPath()
    ctx.rect(0, 0, width, height)
    ctx.clip()
    inPixels(ctx, 1)
    ctx.fillStyle = grains!
    ctx.fillRect(0, 0, ctx.canvas.width, ctx.canvas.height)
    ctx.restore()
  }
  inMetres(ctx, camera, ratio)
  ctx.lineWidth = 1.5 / camera.scale
  ctx.strokeStyle = palette.edge
  ctx.strokeRect(0, 0, width, height)
  ctx.setLineDash([6 / camera.scale, 6 / camera.scale])
  ctx.lineWidth = 1 / camera.scale
  ctx.strokeStyle = palette.field
  ctx.beginPath()
  ring(ctx, drawing.border)
  ctx.stroke()
  ctx.setLineDash([])
  for (const rings of drawing.keep_out) {
    ctx.beginPath()
    for (const points of rings) ring(ctx, points)
    ctx.fillStyle = palette.keepOut
    ctx.fill('evenodd')
    ctx.strokeStyle = palette.keepOutEdge
    ctx.stroke()
  }
}

function ring(ctx: Ctx, points: number[]): void {
  for (let i = 0; i + 1 < points.length; i += 2)
    if (i === 0) ctx.moveTo(points[0], points[1])
    else ctx.lineTo(points[i], points[i + 1])
  ctx.closePath()
}

/** Metres between lines of the grid: at least 48 pixels, 1, 2 or 5 in front. */
export function gridStep(scale: number): number {
  const least = 48 / scale
  const power = 10 ** Math.floor(Math.log10(least))
  return power * ([1, 2, 5, 10].find((f) => f * power >= least) ?? 10)
}

export function paintGrid(ctx: Ctx, box: Box, scale: number): void {
  const step = gridStep(scale)
  ctx.lineWidth = 1 / scale
  for (const strong of [false, true]) {
    ctx.beginPath()
    for (let i = Math.ceil(box.x0 / step); i * step <= box.x1; i++)
      if ((i % 5 === 0) === strong) {
        ctx.moveTo(i * step, box.y0)
        ctx.lineTo(i * step, box.y1)
      }
    for (let i = Math.ceil(box.y0 / step); i * step <= box.y1; i++)
      if ((i % 5 === 0) === strong) {
        ctx.moveTo(box.x0, i * step)
        ctx.lineTo(box.x1, i * step)
      }
    ctx.strokeStyle = strong ? palette.gridStrong : palette.grid
    ctx.stroke()
  }
}

/** The drawing itself: areas faintly, so that what is not raked yet shows too. */
export class Shapes {
  readonly tracks: Track[]
  constructor(readonly drawing: Drawing) {
    this.tracks = drawing.elements.map((element) => {
      const path = new Path2D()
      const box: Box = { x0: Infinity, y0: Infinity, x1: -Infinity, y1: -Infinity }
      for (const ring of [element.points, ...(element.holes ?? [])]) {
        for (let i = 0; i < ring.length; i += 2) {
          if (i === 0) path.moveTo(ring[0], ring[1])
          else path.lineTo(ring[i], ring[i + 1])
          box.x0 = Math.min(box.x0, ring[i])
          box.x1 = Math.max(box.x1, ring[i])
          box.y0 = Math.min(box.y0, ring[i + 1])
          box.y1 = Math.max(box.y1, ring[i + 1])
        }
        if (element.closed) path.closePath()
      }
      return { path, box }
    })
  }
  /** Lines only where asked for: what is drawn lies over them. */
  paint(ctx: Ctx, box: Box, scale: number, lines: boolean): void {
    ctx.lineWidth = 1 / scale
    this.drawing.elements.forEach((element, i) => {
      if ((!lines && element.kind === 'line') || !overlaps(this.tracks[i].box, box)) return
      if (element.kind === 'region') {
        ctx.fillStyle = palette.area
        ctx.fill(this.tracks[i].path, 'evenodd')
      }
      ctx.strokeStyle = palette.areaEdge
      ctx.stroke(this.tracks[i].path)
    })
  }
}

export interface Span {
  from: number
  to: number
}
const whole = (run: Run, span: Span) => run.first >= span.from && run.last <= span.to
const meets = (run: Run, span: Span) => run.first < span.to && run.last > span.from

function part(tracks: Tracks, run: Run, span: Span, offset: number, detail: number): Track {
  return barTrack(tracks.samples, Math.max(run.first, span.from), Math.min(run.last, span.to), offset, detail)
}

/**
 * Lines of two pixels are three of under one, side by side whichever way they run: those need no outline to be found and
 * filled, and software draws them five times as fast. Where a pixel is several of the screen's a line is stroked as it is.
 */
const beside = [90, 210, 330].map((degrees) => {
  const way = (degrees * Math.PI) / 180
  return { x: 0.5 * Math.cos(way), y: 0.5 * Math.sin(way) }
})
const hair = 0.99 // of a pixel

/** Rake down as lines two pixels wide. */
export function paintOutline(ctx: Ctx, tracks: Tracks, box: Box, camera: Camera, ratio: number, span: Span, colours: boolean): void {
  const { scale } = camera
  const hairs = ratio === 1
  ctx.lineWidth = (hairs ? hair : 2) / scale
  ctx.lineJoin = 'bevel' // at two pixels nobody sees the difference
  ctx.lineCap = 'butt'
  const detail = detailAt(scale)
  const last = Math.max(1, tracks.drive.strokes.length - 1)
  const shown: [Path2D, number][] = []
  tracks.runs.forEach((run, i) => {
    if (run.mask === 0 || !meets(run, span)) return
    const track = whole(run, span) ? tracks.middle(i, detail) : part(tracks, run, span, 0, detail)
    if (overlaps(track.box, box)) shown.push([track.path, run.stroke])
  })
  ctx.strokeStyle = palette.ink
  for (const { x, y } of hairs ? beside : [{ x: 0, y: 0 }]) {
    inMetres(ctx, { scale, x: camera.x + x, y: camera.y + y }, ratio)
    for (const [path, stroke] of shown) {
      if (colours) ctx.strokeStyle = orderColour(stroke / last)
      ctx.stroke(path)
    }
  }
  inMetres(ctx, camera, ratio)
}

/** Each pin's groove: its floor wipes what was there, a dark side and a light one make it deep. Light falls from the upper left. */
export function paintGrooves(ctx: Ctx, tracks: Tracks, box: Box, camera: Camera, ratio: number, span: Span, colours: boolean): void {
  const { pitch } = tracks
  const scale = camera.scale
  const fine = pitch * scale > 2.2
  const detail = detailAt(scale)
  const reach = grown(box, pitch)
  const last = Math.max(1, tracks.drive.strokes.length - 1)
  ctx.lineJoin = 'round'
  ctx.lineCap = 'butt'
  tracks.runs.forEach((run, i) => {
    if (run.mask === 0 || !meets(run, span)) return
    const middle = tracks.middle(i, detail)
    if (!overlaps(middle.box, grown(reach, tracks.pins * pitch))) return
    const pins = whole(run, span) ? tracks.pinTracks(i, detail) : pinsOf(tracks, run, span, detail)
    const stroke = (width: number, style: string, shift: number) => {
      ctx.lineWidth = Math.max(width, 0.6 / scale)
      ctx.strokeStyle = style
      if (shift !== 0) ctx.setTransform(scale * ratio, 0, 0, -scale * ratio, (camera.x + shift) * ratio, (camera.y + shift) * ratio)
      for (const pin of pins) ctx.stroke(pin.path)
      if (shift !== 0) inMetres(ctx, camera, ratio)
    }
    const dark = colours ? orderColour(run.stroke / last) : palette.grooveDark
    stroke(pitch * 1.04, palette.grooveFloor, 0)
    if (fine) {
      const shift = pitch * scale * 0.2
      stroke(pitch * 0.42, dark, -shift * 0.7)
      stroke(pitch * 0.24, palette.grooveLight, shift)
    } else {
      stroke(pitch * 0.55, dark, 0)
    }
  })
}
function pinsOf(tracks: Tracks, run: Run, span: Span, detail: number): Track[] {
  return pinOffsets(run.mask, tracks.pins, tracks.pitch).map((offset) => part(tracks, run, span, offset, detail))
}

function arrowHead(path: Path2D, at: Point, way: number, size: number): void {
  const c = Math.cos(way)
  const s = Math.sin(way)
  path.moveTo(at.x + size * c, at.y + size * s)
  path.lineTo(at.x - size * 0.7 * c - size * 0.6 * s, at.y - size * 0.7 * s + size * 0.6 * c)
  path.lineTo(at.x - size * 0.7 * c + size * 0.6 * s, at.y - size * 0.7 * s - size * 0.6 * c)
  path.closePath()
}

/** Rake up: as driven, or a straight arrow from where the rake is lifted to where it comes down. */
export function paintConnections(ctx: Ctx, tracks: Tracks, box: Box, scale: number, span: Span, simple: boolean): void {
  const s = tracks.samples
  const size = 6 / scale
  const detail = detailAt(scale)
  ctx.lineCap = 'round'
  ctx.strokeStyle = palette.trip
  ctx.fillStyle = palette.trip
  ctx.lineWidth = 1.4 / scale
  const heads = new Path2D()
  tracks.runs.forEach((run, i) => {
    if (run.mask !== 0 || !meets(run, span)) return
    const last = Math.min(run.last, span.to)
    if (simple) {
      const [ax, ay, bx, by] = [s.rakeX[run.first], s.rakeY[run.first], s.rakeX[last], s.rakeY[last]]
      if (Math.hypot(bx - ax, by - ay) < 2 * size) return
      ctx.beginPath()
      ctx.moveTo(ax, ay)
      ctx.lineTo(bx, by)
      ctx.stroke()
      arrowHead(heads, { x: ax + 0.6 * (bx - ax), y: ay + 0.6 * (by - ay) }, Math.atan2(by - ay, bx - ax), size)
      return
    }
    const track = whole(run, span) ? tracks.middle(i, detail) : part(tracks, run, span, 0, detail)
    if (!overlaps(track.box, box)) return
    ctx.setLineDash([5 / scale, 4 / scale])
    ctx.stroke(track.path)
    ctx.setLineDash([])
    const mid = Math.min((run.first + run.last) >> 1, s.count - 2)
    const way = Math.atan2(s.rakeY[mid + 1] - s.rakeY[mid], s.rakeX[mid + 1] - s.rakeX[mid])
    if (track.box.x1 - track.box.x0 + track.box.y1 - track.box.y0 > 4 * size)
      arrowHead(heads, { x: s.rakeX[mid], y: s.rakeY[mid] }, way, size)
  })
  ctx.fill(heads)
}

export function paintWheels(ctx: Ctx, tracks: Tracks, box: Box): void {
  ctx.strokeStyle = palette.wheel
  ctx.lineCap = 'butt'
  const wheels = tracks.drive.robot.wheels
  tracks.wheelTracks().forEach((track, i) => {
    if (!overlaps(track.box, box)) return
    ctx.lineWidth = wheels[i % wheels.length][2]
    ctx.stroke(track.path)
  })
}
