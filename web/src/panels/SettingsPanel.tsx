import { useEffect, useRef, useState } from 'preact/hooks'
import type { Setting } from '../api/client'
import { edit, session, setOption } from '../session'
import { useStore } from '../store'
import { view } from '../view'
import { spoken, written } from './words'

const names: Record<string, string> = {
  canvas: 'Canvas and margin',
  place: 'Placement',
  drawing: 'Drawing',
  ink: 'Ink',
  trace: 'Pictures',
  text: 'Text in drawings',
  fill: 'Filling',
  tour: 'Order',
  corner: 'Corners',
  connect: 'Connections',
  avoid: 'Going round',
  field: 'Field and keep-outs',
  park: 'Parking and exit',
  trajectory: 'Trajectory',
  site: 'Place on earth',
  gcode: 'G-code',
  mission: 'Missions (ArduPilot, QGroundControl)',
  nav: 'ROS 2 paths',
  thr: 'Sand tables (.thr)',
}
const firstOpen = new Set(['canvas', 'place'])

interface FieldShape {
  key: string
  kind: string
  unit: string
  value: string
  meaning: string
  set: boolean
  low?: number
  high?: number
  choices?: string[]
}

/** "0.785rad" -> "45": angles are shown in degrees, lengths in metres. */
function shown(field: FieldShape): string {
  if (field.kind !== 'angle') return field.value
  const radians = field.value.endsWith('rad') ? parseFloat(field.value) : (parseFloat(field.value) * Math.PI) / 180
  return `${+((radians * 180) / Math.PI).toFixed(4)}`
}
function range(field: FieldShape): string {
  if (field.low === undefined || field.high === undefined) return ''
  const f = field.kind === 'angle' ? 180 / Math.PI : 1
  return `${written(field.low * f)} to ${written(field.high * f)}`
}

function Field({ field }: { field: FieldShape }) {
  const unit = field.kind === 'angle' ? '°' : field.unit
  const id = `set-${field.key}`
  const wanted = useStore(view, (v) => v.wantedSetting === field.key)
  const box = useRef<HTMLDivElement>(null)
  useEffect(() => {
    if (!wanted) return
    box.current?.scrollIntoView({ block: 'center' })
    box.current?.querySelector<HTMLElement>('input, select')?.focus()
    view.set({ wantedSetting: '' })
  }, [wanted])
  const send = (value: string) => {
    const text = value.trim()
    // A bare number of degrees; whoever writes a unit means it.
    return setOption(field.key, field.kind === 'angle' && /^[-+.\de]+$/i.test(text) ? `${text}deg` : text)
  }
  /** What is refused does not stand there as if it held. */
  const sendOr = async (value: string, back: () => void) => {
    if (!(await send(value))) back()
  }
  let control
  const on = ['on', 'true', '1'].includes(field.value)
  if (field.kind === 'on or off' || field.unit === 'true/false')
    control = (
      <input
        id={id}
        type="checkbox"
        checked={on}
        onChange={({ currentTarget: box }) => void sendOr(box.checked ? 'on' : 'off', () => (box.checked = on))}
      />
    )
  else if (field.choices)
    control = (
      <select id={id} value={field.value} onChange={({ currentTarget: list }) => void sendOr(list.value, () => (list.value = field.value))}>
        {field.choices.map((choice) => (
          <option value={choice}>{choice}</option>
        ))}
      </select>
    )
  else
    control = (
      <span class="value">
        <input
          id={id}
          type="text"
          inputMode={field.kind === 'text' ? 'text' : 'decimal'}
          value={shown(field)}
          aria-describedby={`${id}-help`}
          onChange={({ currentTarget: input }) => void sendOr(input.value, () => (input.value = shown(field)))}
        />
        <span class="unit">{unit}</span>
      </span>
    )
  return (
    <div class={field.set ? 'setting set' : 'setting'} ref={box}>
      <div class="line">
        <label for={id}>{spoken(field.key)}</label>
        {control}
      </div>
      <div class="help" id={`${id}-help`}>
        {field.meaning}
        {range(field) && <span class="range"> ({range(field)}{unit && ` ${unit}`})</span>}
        {field.set && (
          <button class="link" onClick={() => setOption(field.key, '')}>
            default
          </button>
        )}
      </div>
    </div>
  )
}

/** A robot by its name, or by the text of its profile: whole, without what was set of the one before. */
function takeRobot(name: string, profile: string): void {
  const { set } = session.now.standing!
  const fields = set.filter((key) => key.startsWith('robot.') && key !== 'robot.profile')
  void edit(`robot ${name}`, [
    { set: 'robot', value: profile ? '' : name },
    { set: 'robot.profile', value: profile },
    ...fields.map((key) => ({ set: key, value: '' })),
  ])
}
async function readProfile(input: HTMLInputElement): Promise<void> {
  const file = input.files?.[0]
  if (file) takeRobot(file.name, await file.text())
  input.value = ''
}

export function SettingsPanel() {
  const about = useStore(session, (s) => s.about)
  const standing = useStore(session, (s) => s.standing)
  const wanted = useStore(view, (v) => v.wantedSetting)
  const [search, setSearch] = useState('')
  const profileFile = useRef<HTMLInputElement>(null)
  if (!about || !standing) return null
  const isSet = new Set(standing.set)
  const fieldOf = (s: Setting): FieldShape => ({
    ...s,
    value: standing.settings[s.key] ?? '',
    set: isSet.has(s.key),
  })
  const robot = standing.robot as unknown as Record<string, unknown>
  const groups = new Map<string, FieldShape[]>()
  for (const setting of about.settings) {
    const group = setting.key.split('.')[0]
    groups.set(group, [...(groups.get(group) ?? []), fieldOf(setting)])
  }
  const robotFields: FieldShape[] = about.robot_fields.map((f) => ({
    key: `robot.${f.name}`,
    kind: f.unit === 'true/false' ? 'on or off' : 'number',
    unit: f.unit === 'true/false' || f.unit === 'count' ? '' : f.unit,
    value: String(robot[f.name]),
    meaning: f.meaning,
    set: isSet.has(`robot.${f.name}`),
    low: f.unit === 'true/false' ? undefined : f.low,
    high: f.unit === 'true/false' ? undefined : f.high,
  }))
  const order = ['canvas', 'place', ...[...groups.keys()].filter((g) => !firstOpen.has(g))]
  const matches = (f: FieldShape) => !search || `${f.key} ${f.meaning}`.toLowerCase().includes(search.toLowerCase())
  const section = (name: string, title: string, fields: FieldShape[], before?: preact.JSX.Element) => {
    const some = fields.filter(matches)
    if (some.length === 0 && !(before && !search)) return null
    const open = search !== '' || wanted.startsWith(`${name}.`) || firstOpen.has(name)
    return (
      <details open={open} key={`${name}${open}`}>
        <summary>
          {title}
          {fields.some((f) => f.set) && <span class="dot" title="changed" />}
        </summary>
        {!search && before}
        {some.map((f) => (
          <Field key={f.key} field={f} />
        ))}
      </details>
    )
  }
  const own = isSet.has('robot.profile')
  const profile = (
    <div class="setting">
      <div class="line">
        <label for="set-robot">profile</label>
        <select id="set-robot" value={own ? '' : standing.robot_name} onChange={(e) => takeRobot(e.currentTarget.value, '')}>
          {own && <option value="">{standing.robot_name}</option>}
          {about.robots.map((r) => (
            <option value={r.name}>{r.name}</option>
          ))}
        </select>
      </div>
      <div class="help">
        <button class="link" onClick={() => profileFile.current?.click()}>
          A profile of your own…
        </button>
        <input ref={profileFile} type="file" hidden accept=".toml" aria-label="Robot profile" onChange={(e) => void readProfile(e.currentTarget)} />
      </div>
    </div>
  )
  return (
    <div class="settings">
      <input class="search" type="search" placeholder="Search settings" aria-label="Search settings" value={search} onInput={(e) => setSearch(e.currentTarget.value)} />
      {order.slice(0, 2).map((g) => section(g, names[g] ?? g, groups.get(g) ?? []))}
      {section('robot', 'Robot', robotFields, profile)}
      {order.slice(2).map((g) => section(g, names[g] ?? g, groups.get(g) ?? []))}
    </div>
  )
}
