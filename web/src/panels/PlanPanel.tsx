import type { Drive, Report } from '../api/client'
import { session } from '../session'
import { useStore } from '../store'
import { view } from '../view'
import { area, counted, duration, metres, percent } from './words'

type Show = (x: number, y: number) => void

function Summary({ drive, report }: { drive: Drive; report: Report | null }) {
  const f = drive.figures as Record<string, number>
  const rows: [string, string][] = [
    ['Time', duration(f.time)],
    ['Drawn', metres(f.drawn)],
    ['Rake up', `${metres(f.up_driven + f.loops_driven)} driven, ${metres(f.up_straight)} straight`],
    ['Elements', `${counted(f.lines, 'line')}, ${counted(f.regions, 'area')}; ${counted(f.strokes, 'stroke')}`],
  ]
  if (f.regions > 0 && report) {
    rows.push(['Coverage', `${percent(report.coverage)} of the areas`])
    rows.push(['Raked twice', `${percent(report.overdraw)}; ${percent(report.spill)} outside`])
  }
  if (report) rows.push(['Blemish', `${counted(report.crossings, 'line')} crossed, ${report.driven_over.toFixed(2)} m² driven over`])
  return (
    <dl class="summary">
      {rows.map(([name, value]) => (
        <div>
          <dt>{name}</dt>
          <dd>{value}</dd>
        </div>
      ))}
    </dl>
  )
}

interface Finding {
  kind: string
  text: string
  jump?: () => void
}

function findings(drive: Drive, report: Report | null, show: Show, ids: Set<string>, keys: Set<string>): Finding[] {
  const list: Finding[] = []
  for (const fault of report?.faults ?? []) list.push({ kind: 'fault', text: `${fault.law}: ${fault.what}`, jump: () => show(fault.x, fault.y) })
  for (const spot of drive.undrivable)
    list.push({ kind: 'fault', text: `${spot.what}: ${spot.amount.toFixed(2)}`, jump: () => show(spot.at[0], spot.at[1]) })
  for (const text of drive.idle) list.push({ kind: 'idle', text })
  for (const { place, reason } of drive.warnings) {
    const id = [...ids].find((known) => place === known || place.startsWith(`${known},`) || place.endsWith(`#${known}`))
    const key = place.split(', ').find((part) => keys.has(part))
    const jump = id
      ? () => showElement(id, show)
      : key
        ? () => view.set({ tab: 'settings', wantedSetting: key })
        : undefined
    list.push({ kind: 'warning', text: `${place}: ${reason}`, jump })
  }
  for (const blemish of report?.blemishes ?? [])
    list.push({
      kind: 'blemish',
      text: blemish.crossings > 0 ? `${counted(blemish.crossings, 'finished line')} crossed` : `${area(blemish.area)} of finished sand driven over`,
      jump: () => {
        view.set({ time: blemish.t, playing: false })
        show(blemish.x, blemish.y)
      },
    })
  for (const spot of drive.bare)
    list.push({ kind: 'bare', text: `${area(spot.amount)} of ${spot.what} stay bare`, jump: () => show(spot.at[0], spot.at[1]) })
  return list
}

export function showElement(id: string, show: Show): void {
  const element = session.now.drawing?.elements.find((e) => e.id === id)
  if (!element) return
  let [x, y, n] = [0, 0, 0]
  for (let i = 0; i < element.points.length; i += 2, n++) [x, y] = [x + element.points[i], y + element.points[i + 1]]
  view.set({ selected: id })
  show(x / n, y / n)
}

/** Before the first line: what to begin with. */
function BareSand() {
  return (
    <div>
      <p class="quiet">Bare sand: nothing is drawn yet. Draw with the pen, write some words, or drop a drawing here.</p>
      <button class="secondary" onClick={() => view.set({ tool: 'draw' })}>
        Draw
      </button>{' '}
      <button class="secondary" onClick={() => view.set({ tool: 'text' })}>
        Write
      </button>
    </div>
  )
}

export function PlanPanel({ show }: { show: Show }) {
  const { drive, report, failure, drawing, about, standing } = useStore(session, (s) => s)
  if (standing?.bare) return <BareSand />
  if (failure)
    return (
      <div class="failure" role="alert">
        <b>No plan{drive ? ' of what was changed last; what is shown is the one before' : ' yet'}</b>
        <p>{[failure.place, failure.reason].filter(Boolean).join(': ')}</p>
        {failure.remedy && <p>{failure.remedy}</p>}
      </div>
    )
  if (!drive) return <p class="quiet">The plan is being made.</p>
  const ids = new Set(drawing?.elements.map((e) => e.id))
  const keys = new Set(about?.settings.map((s) => s.key))
  const list = findings(drive, report, show, ids, keys)
  return (
    <div>
      <Summary drive={drive} report={report} />
      <h2>
        {report ? (report.sound ? 'Checked: sound' : `Checked: ${counted(report.faults.length, 'fault')}`) : 'Being checked'}
      </h2>
      {list.length === 0 && <p class="quiet">Nothing to remark.</p>}
      <ul class="findings">
        {list.slice(0, 300).map((finding) => (
          <li class={finding.kind}>
            {finding.jump ? <button onClick={finding.jump}>{finding.text}</button> : <span>{finding.text}</span>}
          </li>
        ))}
      </ul>
      {list.length > 300 && <p class="quiet">and {list.length - 300} more</p>}
    </div>
  )
}
