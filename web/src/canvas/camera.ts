// Metres on the canvas, y up <-> CSS pixels on the screen, y down.
export interface Point {
  x: number
  y: number
}
export interface Camera {
  scale: number // pixels a metre
  x: number // screen x of the origin
  y: number
}
export interface Box {
  x0: number
  y0: number
  x1: number
  y1: number
}

export const emptyBox = (): Box => ({ x0: Infinity, y0: Infinity, x1: -Infinity, y1: -Infinity })
export const toScreen = (c: Camera, p: Point): Point => ({ x: c.x + p.x * c.scale, y: c.y - p.y * c.scale })
export const toWorld = (c: Camera, p: Point): Point => ({ x: (p.x - c.x) / c.scale, y: (c.y - p.y) / c.scale })
export const distance = (a: Point, b: Point) => Math.hypot(a.x - b.x, a.y - b.y)

export function include(box: Box, x: number, y: number): void {
  if (x < box.x0) box.x0 = x
  if (x > box.x1) box.x1 = x
  if (y < box.y0) box.y0 = y
  if (y > box.y1) box.y1 = y
}
export const overlaps = (a: Box, b: Box) => a.x0 <= b.x1 && b.x0 <= a.x1 && a.y0 <= b.y1 && b.y0 <= a.y1
export const grown = (b: Box, by: number): Box => ({ x0: b.x0 - by, y0: b.y0 - by, x1: b.x1 + by, y1: b.y1 + by })

/** What of the world is on a screen of that size. */
export function visible(c: Camera, width: number, height: number): Box {
  const low = toWorld(c, { x: 0, y: height })
  const high = toWorld(c, { x: width, y: 0 })
  return { x0: low.x, y0: low.y, x1: high.x, y1: high.y }
}

export function fitted(box: Box, width: number, height: number, margin: number): Camera {
  const w = Math.max(box.x1 - box.x0, 1e-6)
  const h = Math.max(box.y1 - box.y0, 1e-6)
  const scale = Math.min((width - 2 * margin) / w, (height - 2 * margin) / h)
  return {
    scale,
    x: width / 2 - ((box.x0 + box.x1) / 2) * scale,
    y: height / 2 + ((box.y0 + box.y1) / 2) * scale,
  }
}

/** Zoomed about a place of the screen that stays where it is. */
export function zoomed(c: Camera, at: Point, factor: number): Camera {
  const scale = Math.min(Math.max(c.scale * factor, 0.05), 200000)
  const f = scale / c.scale
  return { scale, x: at.x + (c.x - at.x) * f, y: at.y + (c.y - at.y) * f }
}
