import { posesOf, shaped } from '../plan/shapes'
import type { Pose } from '../plan/shapes'
import { edit, session } from '../session'
import { useStore } from '../store'
import { toolList } from '../tools/tools'
import { view } from '../view'
import { Icon } from './icons'

export function ToolRail({ fit }: { fit: () => void }) {
  const now = useStore(view, (v) => v.tool)
  return (
    <nav class="rail" aria-label="Tools">
      {toolList.map(({ name, label, key }) => (
        <button aria-pressed={now === name} title={`${label} (${key})`} onClick={() => view.set({ tool: name })}>
          <Icon name={name} />
          <span>{label}</span>
        </button>
      ))}
      <span class="gap" />
      <button title="Show all (0)" onClick={fit}>
        <Icon name="fit" />
        <span>Fit</span>
      </button>
    </nav>
  )
}

/** What the tool in hand can be set to. */
export function ToolOptions() {
  const { tool, fill, pen, text } = useStore(view, (v) => v)
  const about = useStore(session, (s) => s.about)
  const styles = about?.settings.find((s) => s.key === 'fill.style')?.choices ?? []
  const pins = useStore(session, (s) => s.standing?.robot.pins ?? 1)
  if (tool === 'fill')
    return (
      <div class="options">
        <label>
          Style
          <select value={fill.style} onChange={(e) => view.set({ fill: { ...fill, style: e.currentTarget.value } })}>
            {styles.map((style) => (
              <option value={style}>{style}</option>
            ))}
          </select>
        </label>
        <label>
          For
          <select value={fill.whole ? 'area' : 'segment'} onChange={(e) => view.set({ fill: { ...fill, whole: e.currentTarget.value === 'area' } })}>
            <option value="area">the whole area</option>
            <option value="segment">one segment</option>
          </select>
        </label>
      </div>
    )
  if (tool === 'shape') return <ShapeOptions />
  const pinField = (
    <label>
      Pins
      <select value={pen.pins} onChange={(e) => view.set({ pen: { ...pen, pins: +e.currentTarget.value } })}>
        {Array.from({ length: pins }, (_, i) => (
          <option value={i + 1}>{i + 1}</option>
        ))}
      </select>
    </label>
  )
  if (tool === 'draw')
    return (
      <div class="options">
        {pinField}
        <label>
          Smooth within
          <select value={pen.smooth} onChange={(e) => view.set({ pen: { ...pen, smooth: +e.currentTarget.value } })}>
            {[0, 0.01, 0.03, 0.1].map((metres) => (
              <option value={metres}>{metres === 0 ? 'as drawn' : `${metres * 100} cm`}</option>
            ))}
          </select>
        </label>
      </div>
    )
  if (tool === 'text')
    return (
      <div class="options">
        <label>
          Words
          <textarea rows={1} value={text.text} onInput={(e) => view.set({ text: { ...text, text: e.currentTarget.value } })} />
        </label>
        <label>
          Font
          <select value={text.font} onChange={(e) => view.set({ text: { ...text, font: e.currentTarget.value } })}>
            {about?.fonts.map((font) => (
              <option value={font.name} title={font.what}>
                {font.name}
              </option>
            ))}
          </select>
        </label>
        <label>
          Height, m
          <input
            type="number"
            min="0.01"
            step="0.1"
            value={text.height}
            onChange={(e) => view.set({ text: { ...text, height: Math.max(0.01, +e.currentTarget.value || 1) } })}
          />
        </label>
        {pinField}
      </div>
    )
  return null
}

/** Buttons for hands without a keyboard. */
function ShapeOptions() {
  const shape = useStore(view, (v) => v.shape)
  const edits = useStore(session, (s) => s.standing?.edits ?? [])
  const poses = shape ? posesOf(edits, shape.from, shape.to) : []
  if (!shape || poses.length === 0) return null
  const lead = (what: string, through: Pose[]) => {
    view.set({ shape: { ...shape, pose: -1 } })
    void edit(`${what} ${shape.from} to ${shape.to}`, [shaped(shape.from, shape.to, through)])
  }
  return (
    <div class="options">
      <button class="secondary" disabled={shape.pose < 0} onClick={() => lead('take a point out of', poses.filter((_, i) => i !== shape.pose))}>
        Take the point out
      </button>
      <button class="secondary" onClick={() => lead('leave to the planner', [])}>
        Leave it to the planner
      </button>
    </div>
  )
}

export function HintLine() {
  const hint = useStore(view, (v) => v.hint)
  const notice = useStore(session, (s) => s.notice)
  return (
    <div class={notice ? 'hint notice' : 'hint'} role="status">
      {notice || hint}
    </div>
  )
}
