import { useEffect, useRef, useState } from 'preact/hooks'
import type { ComponentChildren } from 'preact'
import { api } from '../api/client'
import { deleteProject, newSketch, notify, openFile, openProject, projectId, redo, replaceDrawing, session, undo } from '../session'
import { useStore } from '../store'
import { view } from '../view'
import type { ViewState } from '../view'
import { ExportList } from './ExportList'
import { Icon } from './icons'

/** A button that opens a list; closes on Escape, on a choice, and when something else is clicked. */
function Menu({ label, icon, children }: { label: string; icon: string; children: (close: () => void) => ComponentChildren }) {
  const [open, setOpen] = useState(false)
  const box = useRef<HTMLDivElement>(null)
  useEffect(() => {
    if (!open) return
    const away = (event: PointerEvent) => {
      if (!box.current?.contains(event.target as Node)) setOpen(false)
    }
    const escape = (event: KeyboardEvent) => {
      if (event.key !== 'Escape') return
      event.stopPropagation() // the tool in hand stays
      setOpen(false)
      box.current?.querySelector('button')?.focus()
    }
    window.addEventListener('pointerdown', away)
    window.addEventListener('keydown', escape, { capture: true })
    return () => {
      window.removeEventListener('pointerdown', away)
      window.removeEventListener('keydown', escape, { capture: true })
    }
  }, [open])
  return (
    <div class="menu" ref={box}>
      <button class="plain" aria-label={label} aria-expanded={open} onClick={() => setOpen(!open)}>
        <Icon name={icon} />
        <span class="wide">{label}</span>
      </button>
      {open && <div class="sheet">{children(() => setOpen(false))}</div>}
    </div>
  )
}

function ProjectList({ close }: { close: () => void }) {
  const [projects, setProjects] = useState<string[]>([])
  /** The one that is asked about. */
  const [going, setGoing] = useState('')
  useEffect(() => {
    api
      .projects()
      .then((list) => setProjects(list.projects.map((p) => p.id)))
      .catch((error: Error) => notify(error.message))
  }, [])
  return (
    <>
      <div class="caption">In this folder</div>
      {projects.map((id) =>
        id === going ? (
          <div class="row asked" role="group" aria-label={`Delete ${id}?`}>
            <span>Delete {id} for good?</span>
            <span class="gap" />
            <button
              class="secondary danger"
              onClick={() => {
                void deleteProject(id)
                close()
              }}
            >
              Delete
            </button>
            <button class="secondary" onClick={() => setGoing('')}>
              Keep
            </button>
          </div>
        ) : (
          <div class="project">
            <button
              class="row"
              aria-current={id === projectId()}
              onClick={() => {
                openProject(id).catch((error: Error) => notify(error.message))
                close()
              }}
            >
              {id}
            </button>
            <button class="plain" aria-label={`Delete ${id}`} title={`Delete ${id}`} onClick={() => setGoing(id)}>
              <Icon name="bin" />
            </button>
          </div>
        ),
      )}
    </>
  )
}

function FileRow({ label, take, close }: { label: string; take: (file: File) => unknown; close: () => void }) {
  const file = useRef<HTMLInputElement>(null)
  return (
    <>
      <button class="row" onClick={() => file.current?.click()}>
        {label} …
      </button>
      <input
        ref={file}
        type="file"
        hidden
        aria-label={label}
        accept=".svg,.png,.jpg,.jpeg,.strandline"
        onChange={(event) => {
          const chosen = event.currentTarget.files?.[0]
          if (chosen) take(chosen)
          close()
        }}
      />
    </>
  )
}

function ProjectMenu() {
  return (
    <Menu label="Project" icon="open">
      {(close) => (
        <div>
          <FileRow label="Open a drawing, picture or project" take={openFile} close={close} />
          <FileRow label="Put another drawing in this project's place" take={replaceDrawing} close={close} />
          <button
            class="row"
            onClick={() => {
              void newSketch()
              close()
            }}
          >
            New sketch on bare sand
          </button>
          <a class="row" href={api.fileUrl(projectId())} download onClick={close}>
            Save a copy of the project
          </a>
          <ProjectList close={close} />
        </div>
      )}
    </Menu>
  )
}

function Choice<K extends 'look' | 'connections'>({ of, label, choices }: { of: K; label: string; choices: [ViewState[K], string][] }) {
  const now = useStore(view, (v) => v[of])
  return (
    <div class="choice" role="group" aria-label={label}>
      {choices.map(([value, name]) => (
        <button aria-pressed={now === value} onClick={() => view.set({ [of]: value } as Partial<ViewState>)}>
          {name}
        </button>
      ))}
    </div>
  )
}

function ShowMenu() {
  const now = useStore(view, (v) => v)
  const toggle = (key: 'orderColours' | 'wheels' | 'faults' | 'robot' | 'grid', name: string) => (
    <label class="row">
      <input type="checkbox" checked={now[key]} onChange={() => view.set({ [key]: !now[key] } as Partial<ViewState>)} />
      {name}
    </label>
  )
  return (
    <Menu label="Show" icon="eye">
      {() => (
        <div>
          <div class="caption">Connections</div>
          <Choice of="connections" label="Connections" choices={[['shown', 'As driven'], ['arrows', 'Arrows'], ['hidden', 'Hidden']]} />
          {toggle('orderColours', 'Order as colour, first blue to last red')}
          {toggle('wheels', 'Wheel tracks')}
          {toggle('faults', 'Faults, blemishes and bare places')}
          {toggle('robot', 'Robot to scale')}
          {toggle('grid', 'Grid and ruler')}
        </div>
      )}
    </Menu>
  )
}

export function TopBar() {
  const standing = useStore(session, (s) => s.standing)
  const open = useStore(view, (v) => v.panelOpen)
  const step = (where: 'undo' | 'redo', act: () => unknown, key: string) => (
    <button
      class="plain"
      disabled={!standing || standing[where].count === 0}
      title={standing?.[where].count ? `${where} ${standing[where].next} (${key})` : where}
      aria-label={standing?.[where].count ? `${where} ${standing[where].next}` : where}
      onClick={act}
    >
      <Icon name={where} />
    </button>
  )
  return (
    <header class="topbar">
      <div class="title">
        <h1>{standing?.title ?? 'Strandline'}</h1>
        <Status />
      </div>
      <ProjectMenu />
      {step('undo', undo, 'Ctrl Z')}
      {step('redo', redo, 'Ctrl Shift Z')}
      <span class="gap" />
      <Choice of="look" label="Look" choices={[['outline', 'Outline'], ['realistic', 'Sand']]} />
      <ShowMenu />
      <Menu label="Export" icon="export">
        {(close) => <ExportList close={close} />}
      </Menu>
      <button class="plain" aria-pressed={open} aria-label="Panel" title="Panel" onClick={() => view.set({ panelOpen: !open })}>
        <Icon name="panel" />
      </button>
    </header>
  )
}

/** What is going on, in a word. */
function Status() {
  const { planning, progress, failure, online, standing } = useStore(session, (s) => s)
  if (!online) return <span class="status bad">server away</span>
  if (planning) return <span class="status busy">planning{progress ? `: ${progress.what}` : ''}</span>
  if (standing?.bare) return <span class="status">bare sand</span>
  if (failure) return <span class="status bad">no plan</span>
  return <span class="status">saved</span>
}
