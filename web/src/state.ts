// What a page knows of the open project. session.ts changes it, panels and tools listen to it.
import type { About, Drawing, Drive, Failure, ProgressEvent, Report, Standing } from './api/client'
import { noSamples } from './plan/samples'
import type { Samples } from './plan/samples'
import { Store } from './store'

export interface SessionState {
  about: About | null
  standing: Standing | null
  drawing: Drawing | null
  drive: Drive | null
  samples: Samples
  report: Report | null
  /** Revision of the project that the plan shown was made from. */
  planned: number
  planning: boolean
  progress: ProgressEvent | null
  failure: Failure | null
  online: boolean
  notice: string
  /** What an edit that waits for the server does; empty: none waits. */
  waiting: string
  /** What the writer of the file that was saved last has to say. */
  saved: { name: string; warnings: string[] } | null
}

export const session = new Store<SessionState>({
  about: null,
  standing: null,
  drawing: null,
  drive: null,
  samples: noSamples,
  report: null,
  planned: 0,
  planning: false,
  progress: null,
  failure: null,
  online: true,
  notice: '',
  waiting: '',
  saved: null,
})

let noticeTimer = 0
export function notify(notice: string): void {
  session.set({ notice })
  window.clearTimeout(noticeTimer)
  if (notice) noticeTimer = window.setTimeout(() => session.set({ notice: '' }), 8000)
}

export function projectId(): string {
  return session.now.standing?.id ?? ''
}
