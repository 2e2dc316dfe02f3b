// An edit that the server was away for: it is kept here, one at most, and sent when the server answers again.
import { api, Refusal } from './api/client'
import type { Change, Edit, Standing } from './api/client'
import { notify, session } from './state'

const retryAfter = 1000 // milliseconds

/** What would come behind an edit that waits is refused in words. */
export function refusedWhileWaiting(what: string): boolean {
  const { waiting } = session.now
  if (waiting) notify(`"${what}" is not kept: the server is away, and "${waiting}" waits for it already.`)
  return waiting !== ''
}

/** Sends the edit once the server is back: if it was not taken after all, and nobody changed the project. Throws what is to be said
 * where it is not kept. */
export async function sendWhenBack(id: string, revision: number, what: string, changes: Change[]): Promise<void> {
  session.set({ waiting: what })
  try {
    while (!(await sent(id, revision, what, changes)));
  } finally {
    session.set({ waiting: '' })
  }
  notify(`The server is back, and "${what}" is kept.`)
}

/** False: the server is still away. */
async function sent(id: string, revision: number, what: string, changes: Change[]): Promise<boolean> {
  await new Promise((done) => window.setTimeout(done, retryAfter))
  if (!session.now.waiting) throw new Error(`"${what}" was dropped.`)
  try {
    const now = await api.standing(id)
    // It had come, only the answer was lost.
    const taken = now.revision === revision + 1 && now.undo.next === what && changes.every((change) => holds(change, now))
    if (!taken && now.revision !== revision)
      throw new Error(`"${what}" is lost: the project was changed elsewhere while the server was away. Make it once more.`)
    if (!taken) await api.edit(id, revision, what, changes)
    return true
  } catch (error) {
    if (error instanceof Refusal && error.isAway) return false
    throw error
  }
}

/** Two pages may do what is called the same: what is drawn tells whose it is. */
function holds(change: Change, now: Standing): boolean {
  return !('edit' in change) || now.edits.some((edit) => sorted(edit) === sorted(change.edit))
}
const sorted = (edit: Edit) => JSON.stringify(Object.entries(edit).sort(([a], [b]) => a.localeCompare(b)))

export const dropWaiting = () => session.set({ waiting: '' })
