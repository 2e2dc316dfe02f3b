import { endDropped, endOf, keepOutsSet, borderSet, withoutCorner, fencesOf } from '../plan/fences'
import { nameOf, posesOf, shaped } from '../plan/shapes'
import type { Pose } from '../plan/shapes'
import { edit, session } from '../session'
import { useStore } from '../store'
import { toolList } from '../tools/tools'
import type { Offer } from '../view'
import { view } from '../view'
import { dropWaiting } from '../waiting'
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
  if (tool === 'field') return <FieldOptions />
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
  const poses = shape ? posesOf(edits, shape) : []
  if (!shape || poses.length === 0) return null
  const lead = (what: string, through: Pose[]) => {
    view.set({ shape: { ...shape, pose: -1 } })
    void edit(`${what} ${nameOf(shape)}`, [shaped(shape, through)])
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

/** What of the field is drawn, and buttons for hands without a keyboard. */
function FieldOptions() {
  const { what, corner } = useStore(view, (v) => v.field)
  const settings = useStore(session, (s) => s.standing?.settings ?? {})
  const drawing = useStore(session, (s) => s.drawing)
  const own = what === 'park' || what === 'exit' ? endOf(settings, what) !== null : settings[what === 'border' ? 'field.border' : 'field.keep_out'] !== ''
  const drop = () => {
    view.set({ field: { what, corner: null } })
    if (what === 'border') return edit('the border as by default', [borderSet([])])
    if (what === 'keep-out') return edit('no keep-outs', [keepOutsSet([])])
    return edit(what === 'park' ? 'parked nowhere' : 'no exit', endDropped(settings, what))
  }
  const dropCorner = () => {
    const left = withoutCorner(fencesOf(settings, drawing), corner!.fence, corner!.corner)
    view.set({ field: { what, corner: null } })
    void edit('take a corner out', [corner!.fence === 0 ? borderSet(left[0]) : keepOutsSet(left.slice(1))])
  }
  return (
    <div class="options">
      <label>
        Draw
        <select value={what} onChange={(e) => view.set({ field: { what: e.currentTarget.value as typeof what, corner: null } })}>
          <option value="keep-out">keep-outs</option>
          <option value="border">the border</option>
          <option value="park">where it is parked</option>
          <option value="exit">where it ends</option>
        </select>
      </label>
      {what === 'exit' && (
        <label>
          Ends
          <select value={settings['park.exit']} onChange={(e) => edit(`exit ${e.currentTarget.value}`, endDropped(settings, 'exit', e.currentTarget.value === 'none' ? '' : e.currentTarget.value))}>
            <option value="none">at the last stroke</option>
            <option value="outside">outside the drawing</option>
            {settings['park.parked'] === 'on' && <option value="parked">where it was parked</option>}
            {settings['park.exit'] === 'pose' && <option value="pose">where it was put</option>}
          </select>
        </label>
      )}
      {corner && (
        <button class="secondary" onClick={dropCorner}>
          Take the corner out
        </button>
      )}
      {own && (
        <button class="secondary" onClick={() => void drop()}>
          {what === 'border' ? 'By default' : what === 'keep-out' ? 'None' : 'Nowhere of its own'}
        </button>
      )}
    </div>
  )
}

const offered: Record<Offer, string> = { cancel: 'Cancel', 'let-go': 'Let go', finish: 'Close it', delete: 'Delete' }

/** What to do next, or what happened; beside it as buttons what Escape, Enter and Delete do. */
export function HintLine({ take }: { take: (offer: Offer) => void }) {
  const { hint, offers } = useStore(view, (v) => v)
  const { notice, waiting } = useStore(session, (s) => s)
  const waits = waiting && `The server is away. "${waiting}" waits here and is sent when strandline serve runs again: leave this page open.`
  return (
    <div class="foot">
      <div class={notice || waits ? 'hint notice' : 'hint'} role="status">
        {notice || waits || hint}
      </div>
      {waits && (
        <button class="secondary" onClick={dropWaiting}>
          Drop it
        </button>
      )}
      {offers.map((offer) => (
        <button class={offer === 'delete' ? 'secondary danger' : 'secondary'} onClick={() => take(offer)}>
          {offered[offer]}
        </button>
      ))}
    </div>
  )
}
