// What is looked at and with which tool: not part of the project.
import { Store } from './store'

export type ToolName = 'select' | 'link' | 'shape' | 'start' | 'end' | 'entry' | 'fill' | 'cut' | 'field' | 'draw' | 'text' | 'erase'
export type Tab = 'plan' | 'order' | 'settings' | 'changes'

/** Buttons for what Escape (of what was begun, of what is chosen), Enter and Delete do. */
export type Offer = 'cancel' | 'let-go' | 'finish' | 'delete'

export interface ViewState {
  look: 'outline' | 'realistic'
  connections: 'shown' | 'arrows' | 'hidden'
  orderColours: boolean
  wheels: boolean
  faults: boolean
  robot: boolean
  grid: boolean
  tool: ToolName
  hint: string
  /** What the tool can do now that keys do too: buttons beside the hint. */
  offers: Offer[]
  tab: Tab
  panelOpen: boolean
  /** Ids of elements. */
  selected: string
  hovered: string
  /** Seconds; null: the whole plan is shown. */
  time: number | null
  playing: boolean
  speed: number
  /** A setting that the settings panel is to show. */
  wantedSetting: string
  fill: { style: string; whole: boolean }
  /** The connection that is being shaped, and which of its points is meant (-1: none). */
  shape: { from: string; to: string; hop?: number[]; pose: number } | null
  /** What the field tool draws, and which corner of which fence is meant (0: the border). */
  field: { what: 'border' | 'keep-out' | 'park' | 'exit'; corner: { fence: number; corner: number } | null }
  pen: { pins: number; smooth: number }
  text: { text: string; font: string; height: number; align: 'left' | 'centre' | 'right' }
}

export const view = new Store<ViewState>({
  look: 'outline',
  connections: 'shown',
  orderColours: false,
  wheels: false,
  faults: true,
  robot: true,
  grid: true,
  tool: 'select',
  hint: '',
  offers: [],
  tab: 'plan',
  panelOpen: window.innerWidth > 720,
  selected: '',
  hovered: '',
  time: null,
  playing: false,
  speed: 20,
  wantedSetting: '',
  fill: { style: 'zigzag', whole: true },
  shape: null,
  field: { what: 'keep-out', corner: null },
  pen: { pins: 1, smooth: 0.03 },
  text: { text: 'Hello', font: 'scripts', height: 1, align: 'left' },
})
