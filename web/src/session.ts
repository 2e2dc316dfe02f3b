// The open project: what holds, the newest plan, and what is asked of the server. Every panel and tool goes through here.
import { api, Refusal } from './api/client'
import type { Change, Edit, ProgressEvent, Standing, StandingEvent } from './api/client'
import { noSamples, readSamples } from './plan/samples'
import type { Samples } from './plan/samples'
import { notify, projectId, session } from './state'
import { refusedWhileWaiting, sendWhenBack } from './waiting'

export { notify, projectId, session }
export type { SessionState } from './state'

let events: EventSource | null = null
const noTags = { revision: 0, drawing: '', drive: '', samples: '', report: '' }
let tags = noTags
/** Number of the newest answer or event taken over; answers overtake one another on their way. */
let newest = 0
/** The project that is open or being opened. */
let current = ''
let queue: Promise<unknown> = Promise.resolve()

/** One after the other: edits name the revision that the one before gave. */
function inTurn<T>(work: () => Promise<T>): Promise<T | undefined> {
  const done = queue.then(work).catch((error: unknown) => {
    notify(error instanceof Error ? error.message : String(error))
    return undefined
  })
  queue = done
  return done
}

async function refreshStanding(id: string): Promise<Standing> {
  let standing = await api.standing(id)
  while (id === current && standing.news < newest) standing = await api.standing(id)
  if (id !== current) return standing
  newest = standing.news
  session.set({ standing, planning: standing.planning, failure: standing.failure ?? null })
  return standing
}

async function newSamples(id: string, before: Samples): Promise<Samples> {
  const { bytes, tag } = await api.samples(id, before.tag)
  return readSamples(bytes, tag, before)
}

/** Nothing is drawn any more: what was planned is not shown as if it held. */
function takeBareSand(): void {
  const { drawing } = session.now
  tags = noTags
  session.set({ drawing: drawing && { ...drawing, elements: [] }, drive: null, samples: noSamples, report: null })
}

/** Takes over the parts of the plan that changed. Drawing, drive and samples belong together and are shown together. */
async function takePlan(id: string, plan: StandingEvent['plan']): Promise<void> {
  if (!plan) return session.now.standing?.bare ? takeBareSand() : undefined
  const [drawing, drive, samples] = await Promise.all([
    plan.drawing === tags.drawing ? session.now.drawing : api.drawing(id),
    plan.drive === tags.drive ? session.now.drive : api.drive(id),
    plan.samples === session.now.samples.tag ? session.now.samples : newSamples(id, session.now.samples),
  ])
  const report = plan.report === '' ? null : plan.report === tags.report ? session.now.report : await api.report(id)
  if (id !== current) return
  tags = plan
  session.set({ drawing, drive, samples, report, planned: plan.revision })
}

async function heard(id: string, event: StandingEvent): Promise<void> {
  if (id !== current || event.news < newest) return
  newest = event.news
  session.set({ planning: event.planning, failure: event.failure ?? null, progress: event.planning ? session.now.progress : null })
  const { standing } = session.now
  if (event.revision !== standing?.revision) await refreshStanding(id)
  else session.set({ standing: { ...standing, planning: event.planning, failure: event.failure, plan: event.plan } })
  await takePlan(id, event.plan)
}

function listen(id: string): void {
  events?.close()
  events = new EventSource(api.eventsUrl(id))
  let last: Promise<void> = Promise.resolve()
  let turns = 0
  events.addEventListener('standing', (message) => {
    const turn = ++turns
    const event = JSON.parse(message.data) as StandingEvent
    // The newest says all there is: those it overtook need not be fetched.
    last = last.then(() => (turn === turns ? heard(id, event) : undefined)).catch(() => undefined)
  })
  events.addEventListener('progress', (message) => session.set({ progress: JSON.parse(message.data) as ProgressEvent }))
  events.onopen = () => session.set({ online: true })
  events.onerror = () => {
    // The next one that answers may be another server, which counts from the beginning.
    newest = 0
    session.set({ online: false })
    // Not away, but refused: a browser asks no more.
    if (events?.readyState === EventSource.CLOSED) leaveIfDeleted(id).catch((error: Error) => notify(error.message))
  }
}

const reconnectAfter = 3000 // milliseconds, as browsers do where nobody answers

/** Whether another page deleted the project that is open here; then the next one is opened. */
async function leaveIfDeleted(id: string): Promise<void> {
  try {
    await api.standing(id)
    window.setTimeout(() => id === current && !document.hidden && listen(id), reconnectAfter)
  } catch (error) {
    if (!(error instanceof Refusal) || error.status !== 404 || id !== current) throw error
    await openAny()
    notify(`${id} was deleted.`)
  }
}

export async function openProject(id: string): Promise<void> {
  await api.standing(id) // one that cannot be opened leaves this one open
  events?.close()
  current = id
  tags = noTags
  newest = 0
  notify('')
  session.set({ drawing: null, drive: null, samples: noSamples, report: null, planned: 0, progress: null, failure: null, saved: null })
  await refreshStanding(id)
  const url = new URL(location.href)
  url.searchParams.set('project', id)
  history.replaceState(null, '', url)
  document.title = `${session.now.standing?.title ?? id} · Strandline`
  listen(id)
}

/** Pages in the background give their connection back: browsers have only six for a server. */
export function followVisibility(): void {
  document.addEventListener('visibilitychange', () => {
    const id = projectId()
    if (!id) return
    if (document.hidden) {
      events?.close()
      events = null
    } else if (!events) {
      listen(id)
    }
  })
}

/** Whether a line would take the place of one that another page drew meanwhile, under the same name. */
function takesPlace(changes: Change[], before: Edit[], now: Edit[]): boolean {
  const drawn = (edits: Edit[]) => new Set(edits.map((e) => (e.edit === 'draw' ? e.element : '')))
  const known = drawn(before)
  const fresh = drawn(now)
  return changes.some((c) => 'edit' in c && c.edit.edit === 'draw' && fresh.has(c.edit.element) && !known.has(c.edit.element))
}

/** Changes taken in one step. A stale revision (another tab was quicker) is read again and the step taken once more; one that the
 * server was away for waits for it. False: it was not kept, and why was said. */
export function edit(what: string, changes: Change[]): Promise<boolean> {
  if (refusedWhileWaiting(what)) return Promise.resolve(false)
  return inTurn(async () => {
    const id = projectId()
    const { revision } = session.now.standing!
    try {
      await api.edit(id, revision, what, changes)
    } catch (error) {
      if (!(error instanceof Refusal)) throw error
      if (error.isAway) await waitAndSend(id, revision, what, changes)
      else if (error.status !== 409) throw error
      else {
        const { edits } = session.now.standing!
        const newest = await refreshStanding(id)
        if (takesPlace(changes, edits, newest.edits)) throw new Error(`"${what}" is lost: the same name was drawn elsewhere. Make it once more.`)
        await api.edit(id, newest.revision, what, changes)
      }
    }
    await refreshStanding(id)
    return true
  }).then((done) => done === true)
}

export const setOption = (key: string, value: string) => edit(`${key} ${value || 'default'}`, [{ set: key, value }])

async function waitAndSend(id: string, revision: number, what: string, changes: Change[]): Promise<void> {
  try {
    await sendWhenBack(id, revision, what, changes)
  } finally {
    newest = 0 // it may be another server, which counts from the beginning
  }
  if (!session.now.online && id === current) listen(id)
}

function move(where: 'undo' | 'redo'): Promise<unknown> {
  if (refusedWhileWaiting(where)) return Promise.resolve()
  return inTurn(async () => {
    const { standing } = session.now
    if (!standing || standing[where].count === 0) return
    await api[where](standing.id, standing.revision)
    await refreshStanding(standing.id)
  })
}
export const undo = () => move('undo')
export const redo = () => move('redo')

/** A file without bytes would be taken for bare sand. */
function full(file: File): File {
  if (file.size === 0) throw new Error(`${file.name} is empty: choose another file`)
  return file
}

/** Becomes a project of its own. */
export function openFile(file: File): Promise<unknown> {
  if (refusedWhileWaiting(`open ${file.name}`)) return Promise.resolve()
  return inTurn(async () => {
    const made = await api.create(file.name, full(file))
    await openProject(made.id)
  })
}
export function replaceDrawing(file: File): Promise<unknown> {
  if (refusedWhileWaiting(`open ${file.name}`)) return Promise.resolve()
  return inTurn(async () => {
    const { standing } = session.now
    await api.source(standing!.id, standing!.revision, file.name, full(file))
    await refreshStanding(standing!.id)
  })
}
export function newSketch(): Promise<unknown> {
  if (refusedWhileWaiting('new sketch')) return Promise.resolve()
  return inTurn(async () => openProject((await api.create('sketch', '')).id))
}

/** The project of that id, else the first one, else a new sketch. */
async function openAny(wanted: string | null = null): Promise<void> {
  const { projects } = await api.projects()
  await openProject(projects.find((p) => p.id === wanted)?.id ?? projects[0]?.id ?? (await api.create('sketch', '')).id)
}

/** For good: whoever calls this has asked. The project that is open gives way to another. */
export function deleteProject(id: string): Promise<unknown> {
  if (refusedWhileWaiting(`delete ${id}`)) return Promise.resolve()
  return inTurn(async () => {
    if (id === current) events?.close()
    try {
      await api.remove(id)
    } catch (error) {
      if (id === current) listen(id)
      throw error
    }
    if (id === current) await openAny()
    notify(`${id} is deleted.`)
  })
}

export async function begin(): Promise<void> {
  session.set({ about: await api.about() })
  await openAny(new URL(location.href).searchParams.get('project'))
  followVisibility()
  window.addEventListener('beforeunload', (event) => {
    if (session.now.waiting) event.preventDefault()
  })
}
