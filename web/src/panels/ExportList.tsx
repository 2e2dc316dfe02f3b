import { useEffect, useState } from 'preact/hooks'
import { api } from '../api/client'
import { notify, projectId, session } from '../session'
import { useStore } from '../store'
import { Icon } from './icons'
import { counted } from './words'

/** Hands a file to the browser, which keeps it where it keeps what it downloads. */
function save(name: string, bytes: Blob): void {
  const link = document.createElement('a')
  link.href = URL.createObjectURL(bytes)
  link.download = name
  link.click()
  // The download has begun by then, also where the browser asks first where to keep it.
  window.setTimeout(() => URL.revokeObjectURL(link.href), 60000)
}

/** What the writer of a file has to say, until it is put away or something else is saved. */
export function SavedCard() {
  const saved = useStore(session, (s) => s.saved)
  const away = () => session.set({ saved: null })
  useEffect(() => {
    if (!saved) return
    const escape = (event: KeyboardEvent) => event.key === 'Escape' && away()
    window.addEventListener('keydown', escape)
    return () => window.removeEventListener('keydown', escape)
  }, [saved])
  return (
    <div role="status">
      {saved && (
        <section class="card saved" aria-label="Saved">
          <header>
            <span>
              <b>{saved.name}</b> is saved, with {counted(saved.warnings.length, 'warning')}:
            </span>
            <button class="plain" aria-label="Put away" onClick={away}>
              <Icon name="close" />
            </button>
          </header>
          <ul class="findings">
            {saved.warnings.map((warning) => (
              <li class="warning">
                <span>{warning}</span>
              </li>
            ))}
          </ul>
        </section>
      )}
    </div>
  )
}

/** Every format. The list closes when the file is saved, and stays where that is refused: another may do. */
export function ExportList({ close }: { close: () => void }) {
  const formats = useStore(session, (s) => s.about?.exports)
  const planned = useStore(session, (s) => s.drive !== null && !s.planning && s.failure === null)
  const [writing, setWriting] = useState('')
  const write = async (format: string) => {
    setWriting(format)
    session.set({ saved: null })
    try {
      const { bytes, name, warnings } = await api.exported(projectId(), format)
      save(name, bytes)
      if (warnings.length > 0) session.set({ saved: { name, warnings } })
      return close()
    } catch (error) {
      notify((error as Error).message)
    }
    setWriting('')
  }
  return (
    <div>
      {!planned && <div class="caption">The plan is not ready yet.</div>}
      {planned &&
        formats?.map((format) => (
          <button class="row format" disabled={writing !== ''} onClick={() => void write(format.name)}>
            <b>{format.name}</b>
            <small>{format.name === writing ? 'being written' : format.what}</small>
          </button>
        ))}
    </div>
  )
}
