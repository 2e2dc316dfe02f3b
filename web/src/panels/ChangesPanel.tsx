import type { Edit } from '../api/client'
import { nameOf } from '../plan/shapes'
import { edit, session } from '../session'
import { useStore } from '../store'
import { view } from '../view'
import { Icon } from './icons'

function described(e: Edit): string {
  const node = (at: (string | number)[]) => `${at[0]}, node ${at[1]}`
  switch (e.edit) {
    case 'link':
      return `from ${node(e.a)} to ${node(e.b)}`
    case 'entry':
      return `enter ${node(e.at)}`
    case 'direction':
      return `${e.element} ${e.direction}`
    case 'hint':
      return e.name === 'ink' ? `${e.element} erased` : `${e.element}: ${e.name.replaceAll('-', ' ')} ${e.value}`
    case 'order':
      return `${e.elements.length} elements in a given order`
    case 'through':
      return `${nameOf(e)} through ${e.poses.length} point${e.poses.length > 1 ? 's' : ''}`
    case 'draw':
      return `${e.element}: ${e.paths.length} line${e.paths.length > 1 ? 's' : ''} by hand`
  }
}

/** What was changed and holds: each can be taken back by itself. */
export function ChangesPanel() {
  const standing = useStore(session, (s) => s.standing)
  if (!standing) return null
  const { edits, set, settings } = standing
  return (
    <div>
      <h2>Edits</h2>
      {edits.length === 0 && <p class="quiet">None yet. Every tool leaves one here.</p>}
      <ul class="changes">
        {edits.map((e) => (
          <li>
            <span>{described(e)}</span>
            <button class="plain" aria-label={`Take back: ${described(e)}`} onClick={() => edit(`take back: ${described(e)}`, [{ drop: e }])}>
              <Icon name="close" />
            </button>
          </li>
        ))}
      </ul>
      <h2>Settings</h2>
      {set.length === 0 && <p class="quiet">All at their defaults.</p>}
      <ul class="changes">
        {set.map((key) => (
          <li>
            <button class="link" onClick={() => view.set({ tab: 'settings', wantedSetting: key })}>
              {key}
              {settings[key] !== undefined && ` = ${settings[key]}`}
            </button>
            <button class="plain" aria-label={`Default for ${key}`} onClick={() => edit(`${key} default`, [{ set: key, value: '' }])}>
              <Icon name="close" />
            </button>
          </li>
        ))}
      </ul>
    </div>
  )
}
