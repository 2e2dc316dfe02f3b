// The server's API: typed by the schema that openapi.json generates.
import type { components } from './schema'

type Schemas = components['schemas']
export type About = Schemas['About']
export type Setting = Schemas['Setting']
export type Robot = Schemas['Robot']
export type Standing = Schemas['Standing']
export type StandingEvent = Schemas['StandingEvent']
export type ProgressEvent = Schemas['ProgressEvent']
export type Drawing = Schemas['Drawing']
export type Element = Schemas['Element']
export type Drive = Schemas['Drive']
export type Report = Schemas['Report']
export type Edit = Schemas['Edit']
export type Change = Schemas['Change']
export type Lettered = Schemas['Lettered']
export type Failure = Schemas['Failure']

/** What the server says when it will not: place, reason, remedy. */
export class Refusal extends Error {
  constructor(
    readonly status: number,
    readonly error: Schemas['Error']['error'],
  ) {
    super([error.place && `${error.place}: `, error.reason, error.remedy && `; ${error.remedy}`].join(''))
  }
  /** Nobody answered: it may have come all the same. */
  get isAway(): boolean {
    return this.status === 0
  }
}

async function ask(path: string, init?: RequestInit): Promise<Response> {
  let reply: Response
  try {
    reply = await fetch(`/api/v1/${path}`, init)
  } catch {
    throw new Refusal(0, {
      code: 'away',
      place: '',
      reason: 'the server does not answer',
      remedy: 'start strandline serve again, then try once more',
    })
  }
  if (reply.ok) return reply
  const body = (await reply.json().catch(() => null)) as Schemas['Error'] | null
  throw new Refusal(reply.status, body?.error ?? { code: 'failed', place: path, reason: reply.statusText, remedy: '' })
}

async function get<T>(path: string): Promise<T> {
  return (await (await ask(path)).json()) as T
}
async function post<T>(path: string, body: unknown): Promise<T> {
  const init = { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(body) }
  return (await (await ask(path, init)).json()) as T
}
/** A file, its name and what its writer has to say about it (parted by " | " in a header). */
async function download(path: string): Promise<{ bytes: Blob; name: string; warnings: string[] }> {
  const reply = await ask(path)
  const name = /filename="([^"]+)"/.exec(reply.headers.get('Content-Disposition') ?? '')?.[1] ?? 'strandline'
  const warnings = reply.headers.get('Strandline-Warnings')?.split(' | ') ?? []
  return { bytes: await reply.blob(), name, warnings }
}
async function remove<T>(path: string): Promise<T> {
  return (await (await ask(path, { method: 'DELETE' })).json()) as T
}
async function upload<T>(path: string, bytes: Blob | string): Promise<T> {
  const init = { method: 'POST', headers: { 'Content-Type': 'application/octet-stream' }, body: bytes }
  return (await (await ask(path, init)).json()) as T
}

const project = (id: string) => `projects/${encodeURIComponent(id)}`
export const api = {
  about: () => get<About>('about'),
  projects: () => get<Schemas['Projects']>('projects'),
  create: (title: string, bytes: Blob | string) =>
    upload<Schemas['Project']>(`projects?title=${encodeURIComponent(title)}`, bytes),
  remove: (id: string) => remove<Schemas['Project']>(project(id)),
  standing: (id: string) => get<Standing>(project(id)),
  edit: (id: string, revision: number, what: string, changes: Change[]) =>
    post<Schemas['Revision']>(`${project(id)}/edits`, { revision, what, changes }),
  undo: (id: string, revision: number) => post<Schemas['Revision']>(`${project(id)}/undo`, { revision }),
  redo: (id: string, revision: number) => post<Schemas['Revision']>(`${project(id)}/redo`, { revision }),
  source: (id: string, revision: number, title: string, bytes: Blob) =>
    upload<Schemas['Revision']>(`${project(id)}/source?revision=${revision}&title=${encodeURIComponent(title)}`, bytes),
  drawing: (id: string) => get<Drawing>(`${project(id)}/plan/drawing`),
  drive: (id: string) => get<Drive>(`${project(id)}/plan/drive`),
  report: (id: string) => get<Report>(`${project(id)}/plan/report`),
  /** With their tag: what is there now may be newer than what was told of. `since`: the tag of those that are there. */
  samples: async (id: string, since: string) => {
    const reply = await ask(`${project(id)}/plan/samples${since && `?since=${since}`}`)
    return { bytes: await reply.arrayBuffer(), tag: (reply.headers.get('ETag') ?? '').replaceAll('"', '') }
  },
  connection: (id: string, plan: number, connection: number, through: [number, number, number][]) =>
    post<Schemas['Led']>(`${project(id)}/connection`, { plan, connection, through }),
  lettering: (wish: Schemas['LetteringWish']) => post<Lettered>('lettering', wish),
  exported: (id: string, format: string) => download(`${project(id)}/exports/${encodeURIComponent(format)}`),
  fileUrl: (id: string) => `/api/v1/${project(id)}/file`,
  eventsUrl: (id: string) => `/api/v1/${project(id)}/events`,
}
