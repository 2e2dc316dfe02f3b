import type { Hand, Stroke } from '../canvas/gestures'
import { isTyping } from '../canvas/gestures'
import type { Stage } from '../canvas/stage'
import { redo, session, undo } from '../session'
import type { Offer, ToolName } from '../view'
import { view } from '../view'
import { CutTool, FillTool } from './fill'
import { DrawTool, TextTool } from './draw'
import { FieldTool } from './field'
import { EndTool, EntryTool, StartTool } from './places'
import { eraseElement, EraseTool, SelectTool } from './select'
import { LinkTool } from './link'
import { ShapeTool } from './shape'
import type { Tool } from './tool'

export const toolList: { name: ToolName; label: string; key: string }[] = [
  { name: 'select', label: 'Select', key: 'V' },
  { name: 'link', label: 'Connect', key: 'C' },
  { name: 'shape', label: 'Shape', key: 'H' },
  { name: 'start', label: 'Start', key: 'S' },
  { name: 'end', label: 'End', key: 'L' },
  { name: 'entry', label: 'Entry', key: 'N' },
  { name: 'fill', label: 'Fill', key: 'F' },
  { name: 'cut', label: 'Cut', key: 'X' },
  { name: 'field', label: 'Field', key: 'B' },
  { name: 'draw', label: 'Draw', key: 'D' },
  { name: 'text', label: 'Text', key: 'T' },
  { name: 'erase', label: 'Erase', key: 'E' },
]

/** Hands what happens on the canvas to the tool that is chosen. */
export class Toolbox implements Hand {
  private readonly tools: Record<ToolName, Tool>
  constructor(private readonly stage: Stage) {
    const kinds = [SelectTool, LinkTool, ShapeTool, StartTool, EndTool, EntryTool, FillTool, CutTool, FieldTool, DrawTool, TextTool, EraseTool]
    const all = kinds.map((T) => new T(stage))
    this.tools = Object.fromEntries(all.map((tool) => [tool.name, tool])) as Record<ToolName, Tool>
    stage.overlay = (ctx) => this.tool.paint(ctx)
    view.listen((now, before) => {
      if (now.tool !== before.tool) this.changed(before.tool)
      else if (now.fill !== before.fill || now.selected !== before.selected) this.say()
    })
    session.listen((now, before) => {
      if (now.standing?.bare !== before.standing?.bare) this.say()
    })
    stage.host.dataset.tool = view.now.tool
    this.say()
    window.addEventListener('keydown', (event) => this.key(event))
  }
  private get tool(): Tool {
    return this.tools[view.now.tool]
  }
  private changed(before: ToolName): void {
    this.tools[before].reset()
    this.stage.host.dataset.tool = view.now.tool
    view.set({ hovered: '' })
    this.say()
    this.stage.refresh()
  }
  private say(): void {
    view.set({ hint: this.tool.hint(), offers: this.tool.offers() })
  }
  /** The buttons beside the hint. */
  take(offer: Offer): void {
    if (offer === 'delete') this.erase()
    else if (offer === 'finish') this.tool.finish()
    else this.tool.reset()
    this.say()
  }
  private erase(): void {
    if (!this.tool.erase() && view.now.selected) void eraseElement(view.now.selected)
  }
  down = (at: Stroke) => this.tool.down(at)
  move = (at: Stroke) => this.tool.move(at)
  up = (at: Stroke) => this.tool.up(at)
  hover = (at: Stroke) => this.tool.hover(at)
  cancel = () => this.tool.cancel()

  private key(event: KeyboardEvent): void {
    const command = event.ctrlKey || event.metaKey
    const key = event.key.toLowerCase()
    if (event.key === 'Escape') {
      // First the tool lets go of what it has begun, then it is put away.
      if (view.now.tool !== 'select') {
        this.tool.reset()
        view.set({ tool: 'select' })
      } else this.tool.reset()
      if (isTyping(event.target)) (event.target as HTMLElement).blur()
      return
    }
    if (isTyping(event.target)) return
    if (command && (key === 'z' || key === 'y')) {
      event.preventDefault()
      void (key === 'y' || event.shiftKey ? redo() : undo())
    }
    if (command || event.altKey) return
    if (key === 'delete' || key === 'backspace') this.erase()
    if (key === 'enter') this.tool.finish()
    if (key === '0') this.stage.fit()
    if (key === 'g') view.set({ grid: !view.now.grid })
    if (key === 'r') view.set({ look: view.now.look === 'outline' ? 'realistic' : 'outline' })
    if (key === 'p') view.set({ playing: !view.now.playing, time: view.now.time ?? 0 })
    const tool = toolList.find((t) => t.key.toLowerCase() === key)
    if (tool) view.set({ tool: tool.name })
  }
}
