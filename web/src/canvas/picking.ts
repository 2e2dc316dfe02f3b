// What lies under the pointer: segments of the drawing in a uniform grid.
import type { Drawing } from '../api/client'
import type { Point } from './camera'

const cellsAcross = 160

export class Picking {
  private cells = new Map<number, number[]>()
  private segments: Float64Array
  private owners: Int32Array
  private size: number
  private x0 = 0
  private y0 = 0

  constructor(private drawing: Drawing) {
    let count = 0
    const rings = drawing.elements.map((e) => [e.points, ...(e.holes ?? [])])
    rings.forEach((list, i) => list.forEach((r) => (count += r.length / 2 - (drawing.elements[i].closed ? 0 : 1))))
    this.segments = new Float64Array(4 * count)
    this.owners = new Int32Array(count)
    let [x1, y1] = [1, 1]
    for (const list of rings)
      for (const ring of list)
        for (let i = 0; i < ring.length; i += 2) {
          this.x0 = Math.min(this.x0, ring[i])
          this.y0 = Math.min(this.y0, ring[i + 1])
          x1 = Math.max(x1, ring[i])
          y1 = Math.max(y1, ring[i + 1])
        }
    this.size = Math.max(x1 - this.x0, y1 - this.y0) / cellsAcross
    let at = 0
    rings.forEach((list, element) => {
      const closed = drawing.elements[element].closed
      for (const ring of list) {
        const n = ring.length / 2
        for (let i = 0; i + (closed ? 0 : 1) < n; i++) {
          const j = (i + 1) % n
          this.put(at++, element, ring[2 * i], ring[2 * i + 1], ring[2 * j], ring[2 * j + 1])
        }
      }
    })
  }

  private key(cx: number, cy: number): number {
    return cx * 4096 + cy
  }

  /** Into every cell that it passes: sampled at half a cell, which misses none by more than a corner. */
  private put(at: number, element: number, ax: number, ay: number, bx: number, by: number): void {
    this.segments.set([ax, ay, bx, by], 4 * at)
    this.owners[at] = element
    const steps = Math.ceil((2 * Math.hypot(bx - ax, by - ay)) / this.size) + 1
    let before = -1
    for (let k = 0; k <= steps; k++) {
      const cx = Math.floor((ax + ((bx - ax) * k) / steps - this.x0) / this.size)
      const cy = Math.floor((ay + ((by - ay) * k) / steps - this.y0) / this.size)
      const key = this.key(cx, cy)
      if (key === before) continue
      before = key
      const cell = this.cells.get(key)
      if (cell) cell.push(at)
      else this.cells.set(key, [at])
    }
  }

  /** The element whose line is nearest within `reach` metres; else the smallest area around the place; -1: none. */
  element(p: Point, reach: number): number {
    let best = -1
    let nearest = reach
    const range = Math.min(Math.ceil(reach / this.size) + 1, cellsAcross)
    const cx = Math.floor((p.x - this.x0) / this.size)
    const cy = Math.floor((p.y - this.y0) / this.size)
    for (let i = cx - range; i <= cx + range; i++)
      for (let j = cy - range; j <= cy + range; j++)
        for (const at of this.cells.get(this.key(i, j)) ?? []) {
          const d = this.distanceTo(at, p)
          if (d < nearest) {
            nearest = d
            best = this.owners[at]
          }
        }
    return best >= 0 ? best : this.areaAt(p)
  }

  areaAt(p: Point): number {
    let best = -1
    let smallest = Infinity
    this.drawing.elements.forEach((element, index) => {
      if (element.kind !== 'region' || (element.area ?? 0) >= smallest) return
      if (!inside(element.points, p) || (element.holes ?? []).some((hole) => inside(hole, p))) return
      best = index
      smallest = element.area ?? 0
    })
    return best
  }

  private distanceTo(at: number, p: Point): number {
    const [ax, ay, bx, by] = this.segments.subarray(4 * at, 4 * at + 4)
    const dx = bx - ax
    const dy = by - ay
    const t = Math.min(1, Math.max(0, ((p.x - ax) * dx + (p.y - ay) * dy) / (dx * dx + dy * dy || 1)))
    return Math.hypot(p.x - ax - t * dx, p.y - ay - t * dy)
  }
}

/** Even-odd. */
export function inside(ring: number[], p: Point): boolean {
  let odd = false
  for (let i = 0, j = ring.length - 2; i < ring.length; j = i, i += 2) {
    const yi = ring[i + 1]
    const yj = ring[j + 1]
    if (yi > p.y !== yj > p.y && p.x < ((ring[j] - ring[i]) * (p.y - yi)) / (yj - yi) + ring[i]) odd = !odd
  }
  return odd
}
