// Places of elements that edits can name: nodes of lines, the start and end of fills.
import type { Drawing, Drive, Element } from '../api/client'
import type { Samples } from './samples'
import type { Point } from '../canvas/camera'

export interface Place extends Point {
  element: string
  node: number
}

/** Where an element may be entered or left: the ends of an open line, every node of a closed one, a fill's start and end. */
export function placesOf(element: Element, index: number, drive: Drive | null, samples: Samples): Place[] {
  const place = (node: number, x: number, y: number): Place => ({ element: element.id, node, x, y })
  if (element.kind === 'region') {
    const strokes = drive?.strokes.filter((s) => s.element === index && s.first >= 0) ?? []
    if (strokes.length === 0) return []
    const [first, last] = [strokes[0].first, strokes[strokes.length - 1].last]
    return [
      place(0, samples.rakeX[first], samples.rakeY[first]),
      place(-1, samples.rakeX[last], samples.rakeY[last]),
    ]
  }
  const nodes = element.nodes ?? []
  const last = nodes.length / 2 - 1
  const all = Array.from({ length: last + 1 }, (_, i) => place(i, nodes[2 * i], nodes[2 * i + 1]))
  return element.closed ? all : [all[0], { ...all[last], node: -1 }]
}

export function allPlaces(drawing: Drawing | null, drive: Drive | null, samples: Samples): Place[] {
  return drawing?.elements.flatMap((element, i) => placesOf(element, i, drive, samples)) ?? []
}

export function nearestPlace(places: Place[], at: Point, reach: number): Place | null {
  let best: Place | null = null
  let nearest = reach
  for (const place of places) {
    const d = Math.hypot(place.x - at.x, place.y - at.y)
    if (d < nearest) [nearest, best] = [d, place]
  }
  return best
}

/** Elements in the order in which they are driven; each once. */
export function drivenOrder(drive: Drive | null): number[] {
  return [...new Set(drive?.strokes.map((s) => s.element) ?? [])]
}
