import { useEffect } from 'preact/hooks'
import { session } from '../session'
import type { Samples } from '../plan/samples'
import { sampleAt } from '../plan/samples'
import { useStore } from '../store'
import { view } from '../view'
import { Icon } from './icons'
import { duration, metres } from './words'

let measured: { samples: Samples; metres: Float64Array } | null = null

/** Metres that the robot has driven at each sample. */
function drivenAt(samples: Samples, index: number): number {
  if (measured?.samples !== samples) {
    const sums = new Float64Array(Math.max(1, samples.count))
    for (let i = 1; i < samples.count; i++)
      sums[i] = sums[i - 1] + Math.sqrt((samples.x[i] - samples.x[i - 1]) ** 2 + (samples.y[i] - samples.y[i - 1]) ** 2)
    measured = { samples, metres: sums }
  }
  return measured.metres[index]
}

export function Playback() {
  const samples = useStore(session, (s) => s.samples)
  const drive = useStore(session, (s) => s.drive)
  const elements = useStore(session, (s) => s.drawing?.elements)
  const { time, playing, speed } = useStore(view, (v) => v)
  const total = samples.count > 0 ? samples.t[samples.count - 1] : 0
  const now = time === null ? total : Math.min(time, total)
  const index = samples.count > 0 ? sampleAt(samples, now) : 0

  useEffect(() => {
    if (!playing) return
    let last = performance.now()
    let frame = requestAnimationFrame(function on(at) {
      const next = (view.now.time ?? 0) + ((at - last) / 1000) * view.now.speed
      last = at
      if (next >= total) return view.set({ time: null, playing: false })
      view.set({ time: next })
      frame = requestAnimationFrame(on)
    })
    return () => cancelAnimationFrame(frame)
  }, [playing, total])

  const stroke = samples.count > 0 ? samples.stroke[index] : -1
  const element = stroke >= 0 && drive ? elements?.[drive.strokes[stroke]?.element]?.id : undefined
  return (
    <footer class="playback">
      <button
        class="plain"
        disabled={total === 0}
        aria-label={playing ? 'Pause' : 'Play'}
        title={`${playing ? 'Pause' : 'Play'} (P)`}
        onClick={() => view.set({ playing: !playing, time: time ?? 0 })}
      >
        <Icon name={playing ? 'pause' : 'play'} />
      </button>
      <button class="plain" aria-label="Show the whole plan" title="Show the whole plan" disabled={time === null} onClick={() => view.set({ time: null, playing: false })}>
        <Icon name="stop" />
      </button>
      <input
        type="range"
        class="time"
        min={0}
        max={total}
        step="any"
        value={now}
        aria-label="Time"
        aria-valuetext={duration(now)}
        onInput={(event) => view.set({ time: +event.currentTarget.value, playing: false })}
      />
      <span class="clock">
        <b>{duration(now)}</b>
        <span>
          {metres(samples.count > 0 ? drivenAt(samples, index) : 0)}
          {time !== null && element ? ` · ${element}` : ''}
        </span>
      </span>
      <label class="speed">
        <span class="wide">Speed</span>
        <select value={speed} aria-label="Speed" onChange={(event) => view.set({ speed: +event.currentTarget.value })}>
          {[1, 5, 20, 60, 200].map((factor) => (
            <option value={factor}>{factor}×</option>
          ))}
        </select>
      </label>
    </footer>
  )
}
