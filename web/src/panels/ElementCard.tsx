import type { Change, Element } from '../api/client'
import { edit, session } from '../session'
import { useStore } from '../store'
import { eraseElement } from '../tools/select'
import { view } from '../view'
import { Icon } from './icons'
import { metres } from './words'

function Asked({ element, name, label, choices }: { element: Element; name: string; label: string; choices: string[] }) {
  const now = element.hints[name] ?? ''
  /** What is refused does not stand there as if it held. */
  const ask = async (list: HTMLSelectElement) => {
    const hint = { edit: 'hint' as const, element: element.id, name, value: list.value }
    const change: Change = list.value ? { edit: hint } : { drop: hint }
    if (!(await edit(`${element.id}: ${name} ${list.value || 'default'}`, [change]))) list.value = now
  }
  return (
    <label class="field">
      {label}
      <select value={now} onChange={(e) => void ask(e.currentTarget)}>
        <option value="">as set for all</option>
        {choices.map((choice) => (
          <option value={choice}>{choice}</option>
        ))}
      </select>
    </label>
  )
}

function Direction({ element }: { element: Element }) {
  const edits = useStore(session, (s) => s.standing?.edits ?? [])
  const asked = edits.find((e) => e.edit === 'direction' && e.element === element.id)
  const now = asked?.edit === 'direction' ? asked.direction : ''
  const choices = element.closed ? (['ccw', 'cw'] as const) : (['forward', 'backward'] as const)
  const words = { ccw: 'counter-clockwise', cw: 'clockwise', forward: 'as drawn', backward: 'backwards' }
  const change = async (list: HTMLSelectElement) => {
    const { value } = list
    const direction = (value || choices[0]) as (typeof choices)[number]
    const turned = { edit: 'direction' as const, element: element.id, direction }
    if (!(await edit(`${element.id} ${value || 'either way'}`, [value ? { edit: turned } : { drop: turned }]))) list.value = now
  }
  return (
    <label class="field">
      Driven
      <select value={now} onChange={(e) => void change(e.currentTarget)}>
        <option value="">either way</option>
        {choices.map((choice) => (
          <option value={choice}>{words[choice]}</option>
        ))}
      </select>
    </label>
  )
}

/** The selected element: what it is, and what it is asked to be. */
export function ElementCard({ show }: { show: (x: number, y: number) => void }) {
  const selected = useStore(view, (v) => v.selected)
  const drawing = useStore(session, (s) => s.drawing)
  const settings = useStore(session, (s) => s.about?.settings ?? [])
  const robot = useStore(session, (s) => s.standing?.robot)
  const element = drawing?.elements.find((e) => e.id === selected)
  if (!element) return null
  const choices = (key: string) => settings.find((s) => s.key === key)?.choices ?? []
  const pins = Array.from({ length: robot?.pins ?? 1 }, (_, i) => String(i + 1))
  return (
    <section class="card" aria-label="Element">
      <header>
        <button class="link" onClick={() => show(element.points[0], element.points[1])}>
          <b>{element.id}</b>
        </button>
        <button class="plain" aria-label="Let go" onClick={() => view.set({ selected: '' })}>
          <Icon name="close" />
        </button>
      </header>
      <p class="quiet">
        {element.kind === 'region'
          ? `area, ${(element.area ?? 0).toFixed(2)} m²`
          : `${element.closed ? 'closed line' : 'line'}, ${metres(element.length)}, ${element.pins} pin${element.pins === 1 ? '' : 's'}`}
        {element.layer && ` · layer ${element.layer}`}
      </p>
      {element.kind === 'region' ? (
        <>
          <Asked element={element} name="fill-style" label="Style" choices={choices('fill.style')} />
          <Asked element={element} name="fill-border" label="Border" choices={['on', 'off']} />
          <Asked element={element} name="fill-partition" label="Parts" choices={choices('fill.partition')} />
        </>
      ) : (
        <>
          <Direction element={element} />
          <Asked element={element} name="pins" label="Pins" choices={pins} />
        </>
      )}
      <Asked element={element} name="field" label="Field" choices={['border', 'keep-out']} />
      <Asked element={element} name="tool" label="Tool" choices={['1', '2', '3', '4']} />
      <button class="secondary danger" onClick={() => eraseElement(element.id)}>
        Erase
      </button>
    </section>
  )
}
