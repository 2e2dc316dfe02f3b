import type { Stroke } from '../canvas/gestures'
import { edit, session } from '../session'
import type { Offer } from '../view'
import { view } from '../view'
import { byKey, press, Tool } from './tool'

export class SelectTool extends Tool {
  readonly name = 'select'
  hint(): string {
    if (view.now.selected) return `What ${view.now.selected} is to be stands in the panel.${byKey('Delete erases it, Escape lets go.')}`
    if (session.now.standing?.bare) return 'Bare sand: draw with the pen, write some words, or drop a drawing here.'
    return `${press()} an element. ${byKey('Right-drag or space-drag moves the view, the wheel zooms, 0 shows all.').trim() || 'Two fingers move and zoom.'}`
  }
  override offers(): Offer[] {
    return view.now.selected ? ['delete', 'let-go'] : []
  }
  down(at: Stroke): void {
    view.set({ selected: this.elementAt(at) })
    this.say()
  }
  hover(at: Stroke): void {
    view.set({ hovered: this.elementAt(at) })
  }
  reset(): void {
    view.set({ selected: '', hovered: '' })
  }
}

export function eraseElement(id: string): Promise<boolean> {
  if (view.now.selected === id) view.set({ selected: '', hovered: '' })
  return edit(`erase ${id}`, [{ edit: { edit: 'hint', element: id, name: 'ink', value: 'off' } }])
}

/** Click, or draw across what is to go. */
export class EraseTool extends Tool {
  readonly name = 'erase'
  private marked = new Set<string>()
  hint(): string {
    return `${press()} an element, or drag across several, to take them out of the drawing. Undo brings them back.`
  }
  hover(at: Stroke): void {
    view.set({ hovered: this.elementAt(at) })
  }
  down(at: Stroke): void {
    this.marked.clear()
    this.move(at)
  }
  move(at: Stroke): void {
    const id = this.elementAt(at)
    if (id) this.marked.add(id)
    view.set({ hovered: id })
  }
  up(): void {
    const ids = [...this.marked]
    this.reset()
    if (ids.length === 0) return
    const what = ids.length === 1 ? `erase ${ids[0]}` : `erase ${ids.length} elements`
    void edit(what, ids.map((element) => ({ edit: { edit: 'hint', element, name: 'ink', value: 'off' } })))
  }
  reset(): void {
    this.marked.clear()
    view.set({ hovered: '' })
  }
}
