// A value that panels and the canvas listen to.
import { useEffect, useState } from 'preact/hooks'

export class Store<T extends object> {
  private listeners = new Set<(now: T, before: T) => void>()
  constructor(private value: T) {}
  get now(): T {
    return this.value
  }
  set(part: Partial<T>): void {
    const before = this.value
    this.value = { ...before, ...part }
    for (const listener of this.listeners) listener(this.value, before)
  }
  listen(listener: (now: T, before: T) => void): () => void {
    this.listeners.add(listener)
    return () => this.listeners.delete(listener)
  }
}

/** The part of a store that a panel shows; the panel is drawn again when that part changes. */
export function useStore<T extends object, P>(store: Store<T>, pick: (value: T) => P): P {
  const [part, setPart] = useState(() => pick(store.now))
  useEffect(() => {
    setPart(() => pick(store.now))
    return store.listen((now) => setPart(() => pick(now)))
  }, [store])
  return part
}
