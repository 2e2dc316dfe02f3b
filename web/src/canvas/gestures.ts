// Pointers and keys -> moving the view, or the tool. Right or middle button, space, or two fingers move; the wheel zooms.
import { toWorld, zoomed } from './camera'
import type { Point } from './camera'
import type { Stage } from './stage'

export interface Stroke {
  screen: Point
  world: Point
  /** Metres that a finger or a pointer may be off. */
  reach: number
  shift: boolean
}
/** What tools hear. */
export interface Hand {
  down(at: Stroke): void
  move(at: Stroke): void
  up(at: Stroke): void
  hover(at: Stroke): void
  /** The stroke is not one after all: a second finger came. */
  cancel(): void
}

export function listenTo(stage: Stage, hand: Hand): void {
  const host = stage.host
  const pointers = new Map<number, Point>()
  let panning = false
  let space = false
  let drawing = false
  let pinch: { middle: Point; apart: number } | null = null

  const place = (event: PointerEvent | WheelEvent): Point => {
    const box = host.getBoundingClientRect()
    return { x: event.clientX - box.left, y: event.clientY - box.top }
  }
  const stroke = (event: PointerEvent): Stroke => {
    const screen = place(event)
    const reach = (event.pointerType === 'touch' ? 22 : 10) / stage.camera.scale
    return { screen, world: toWorld(stage.camera, screen), reach, shift: event.shiftKey }
  }
  const fingers = () => {
    const [a, b] = [...pointers.values()]
    return { middle: { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 }, apart: Math.hypot(a.x - b.x, a.y - b.y) }
  }

  host.addEventListener('pointerdown', (event) => {
    host.focus({ preventScroll: true })
    try {
      host.setPointerCapture(event.pointerId)
    } catch {
      // a pointer that a test made up
    }
    pointers.set(event.pointerId, place(event))
    if (pointers.size === 2) {
      if (drawing) hand.cancel()
      drawing = false
      panning = false
      pinch = fingers()
      return
    }
    panning = event.button === 1 || event.button === 2 || space
    drawing = !panning && event.button === 0 && pointers.size === 1
    if (drawing) hand.down(stroke(event))
  })
  host.addEventListener('pointermove', (event) => {
    const before = pointers.get(event.pointerId)
    const now = place(event)
    if (!before) return hand.hover(stroke(event))
    pointers.set(event.pointerId, now)
    const c = stage.camera
    if (pinch && pointers.size === 2) {
      const next = fingers()
      const moved = { ...c, x: c.x + next.middle.x - pinch.middle.x, y: c.y + next.middle.y - pinch.middle.y }
      stage.gesture(zoomed(moved, next.middle, pinch.apart > 0 ? next.apart / pinch.apart : 1))
      pinch = next
    } else if (panning) stage.gesture({ ...c, x: c.x + now.x - before.x, y: c.y + now.y - before.y })
    else if (drawing) hand.move(stroke(event))
  })
  const ended = (event: PointerEvent) => {
    pointers.delete(event.pointerId)
    if (pointers.size < 2) pinch = null
    if (pointers.size > 0) return
    if (drawing && event.type === 'pointerup') hand.up(stroke(event))
    else if (drawing) hand.cancel()
    drawing = panning = false
  }
  host.addEventListener('pointerup', ended)
  host.addEventListener('pointercancel', ended)
  host.addEventListener('contextmenu', (event) => event.preventDefault())
  host.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault()
      const step = event.deltaMode === 1 ? 16 : 1
      stage.gesture(zoomed(stage.camera, place(event), Math.exp((-event.deltaY * step) / 400)))
    },
    { passive: false },
  )
  window.addEventListener('keydown', (event) => {
    if (event.code !== 'Space' || isTyping(event.target)) return
    if (event.target === host || event.target === document.body) event.preventDefault()
    space = true
    host.classList.add('panning')
  })
  window.addEventListener('keyup', (event) => {
    if (event.code !== 'Space') return
    space = false
    host.classList.remove('panning')
  })
}

export function isTyping(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false
  return target.isContentEditable || ['INPUT', 'TEXTAREA', 'SELECT'].includes(target.tagName)
}
