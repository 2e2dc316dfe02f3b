import { useState } from 'preact/hooks'
import { drivenOrder } from '../plan/nodes'
import { edit, session } from '../session'
import { useStore } from '../store'
import { view } from '../view'
import { Icon } from './icons'
import { showElement } from './PlanPanel'
import { metres } from './words'

/** The elements as they are driven; dragged, or moved by the keys, to where they are to come. */
export function OrderPanel({ show }: { show: (x: number, y: number) => void }) {
  const drive = useStore(session, (s) => s.drive)
  const drawing = useStore(session, (s) => s.drawing)
  const kept = useStore(session, (s) => s.standing?.edits.some((e) => e.edit === 'order') ?? false)
  const selected = useStore(view, (v) => v.selected)
  const [dragged, setDragged] = useState(-1)
  const [over, setOver] = useState(-1)
  if (!drive || !drawing) return <p class="quiet">The plan is being made.</p>
  const order = drivenOrder(drive)
  const ids = order.map((index) => drawing.elements[index].id)

  const move = (from: number, to: number) => {
    setDragged(-1)
    setOver(-1)
    if (from === to || from < 0 || to < 0 || to >= ids.length) return
    const elements = [...ids]
    elements.splice(to, 0, ...elements.splice(from, 1))
    void edit(`move ${ids[from]} to place ${to + 1}`, [{ edit: { edit: 'order', elements } }])
  }
  const place = (event: PointerEvent): number => {
    const row = document.elementFromPoint(event.clientX, event.clientY)?.closest('[data-place]')
    return row ? Number((row as HTMLElement).dataset.place) : -1
  }
  return (
    <div>
      <p class="quiet">
        {kept ? 'Kept in this order. ' : 'Found by the planner. '}
        Drag by the dots to change it, or use Alt with the arrow keys.
      </p>
      {kept && (
        <button class="secondary" onClick={() => edit('leave the order to the planner', [{ drop: { edit: 'order', elements: [] } }])}>
          Leave the order to the planner
        </button>
      )}
      <ol class="order">
        {order.map((index, i) => {
          const element = drawing.elements[index]
          const first = drive.strokes.find((s) => s.element === index)
          return (
            <li
              data-place={i}
              class={[element.id === selected ? 'chosen' : '', over === i && dragged !== i ? (dragged < i ? 'below' : 'above') : ''].join(' ')}
            >
              <span
                class="handle"
                title="Drag"
                onPointerDown={(event) => {
                  event.preventDefault()
                  event.currentTarget.setPointerCapture(event.pointerId)
                  setDragged(i)
                }}
                onPointerMove={(event) => dragged === i && setOver(place(event))}
                onPointerUp={(event) => dragged === i && move(i, place(event))}
                onPointerCancel={() => setDragged(-1)}
              >
                <Icon name="drag" />
              </span>
              <button
                class="name"
                onClick={() => {
                  showElement(element.id, show)
                  if (first && first.first >= 0) view.set({ time: session.now.samples.t[first.first], playing: false })
                }}
                onKeyDown={(event) => {
                  if (!event.altKey || (event.key !== 'ArrowUp' && event.key !== 'ArrowDown')) return
                  event.preventDefault()
                  move(i, event.key === 'ArrowUp' ? i - 1 : i + 1)
                }}
              >
                <span class="number">{i + 1}</span>
                {element.id}
                <small>{element.kind === 'region' ? 'area' : metres(element.length)}</small>
              </button>
            </li>
          )
        })}
      </ol>
    </div>
  )
}
