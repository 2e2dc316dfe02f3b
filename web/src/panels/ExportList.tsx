import { useState } from 'preact/hooks'
import { api } from '../api/client'
import { notify, projectId, session } from '../session'
import { useStore } from '../store'
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

/** Every format. The list closes when the file is saved, and stays where its writer has something to say. */
export function ExportList({ close }: { close: () => void }) {
  const formats = useStore(session, (s) => s.about?.exports)
  const planned = useStore(session, (s) => s.drive !== null && !s.planning && s.failure === null)
  const [writing, setWriting] = useState('')
  const [saved, setSaved] = useState<{ name: string; warnings: string[] } | null>(null)
  const write = async (format: string) => {
    setWriting(format)
    setSaved(null)
    try {
      const { bytes, name, warnings } = await api.exported(projectId(), format)
      save(name, bytes)
      if (warnings.length === 0) return close()
      setSaved({ name, warnings })
    } catch (error) {
      notify((error as Error).message)
    }
    setWriting('')
  }
  return (
    <div>
      <div role="status">
        {saved && (
          <>
            <div class="caption">
              <b>{saved.name}</b> is saved, with {counted(saved.warnings.length, 'warning')}:
            </div>
            <ul class="findings said">
              {saved.warnings.map((warning) => (
                <li class="warning">
                  <span>{warning}</span>
                </li>
              ))}
            </ul>
          </>
        )}
      </div>
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
