// From an edit to the new plan on the screen: milliseconds, with the part until the server has answered (kept on disk).
// STRANDLINE_PROGRAM=... node bench/edits.mjs DRAWING.svg... A number stands for a drawing of so many short lines and rings.
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { loadavg, tmpdir } from 'node:os'
import { join } from 'node:path'
import { openEditor, settled, startBrowser, startServer, tempFolder } from '../tests/editor.mjs'

/** Waves and rings strewn evenly, the same ones every time. */
function strewn(count) {
  let seed = 11
  const random = () => (seed = (Math.imul(seed, 1103515245) + 12345) >>> 0) / 2 ** 32
  const across = Math.ceil(Math.sqrt(count))
  const shapes = Array.from({ length: count }, (_, i) => {
    const [x, y, r] = [10 * ((i % across) + 0.3 + 0.4 * random()), 10 * (Math.floor(i / across) + 0.3 + 0.4 * random()), 1.5 + 1.5 * random()]
    if (i % 4 === 0) return `<circle id="e${i}" cx="${x}" cy="${y}" r="${r}"/>`
    const [c, s] = [r * Math.cos(6.28 * random()), r * Math.sin(6.28 * random())]
    return `<path id="e${i}" d="M${x - c} ${y - s}q${c - s} ${s + c} ${2 * c} ${2 * s}"/>`
  })
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${10 * across} ${10 * across}" fill="none" stroke="black">${shapes.join('\n')}</svg>`
}

/** Two metres for each, and a search of a minute at most. */
function makeRoom(page, count) {
  const side = `${Math.ceil(1.4 * Math.sqrt(count))}`
  return page.evaluate(async (metres) => {
    const { id, revision } = window.strandline.session.now.standing
    const set = (key, value) => ({ set: key, value })
    const body = JSON.stringify({ revision, what: 'room', changes: [set('canvas.width', metres), set('canvas.height', metres), set('tour.moves', '1000')] })
    await fetch(`/api/v1/projects/${id}/edits`, { method: 'POST', headers: { 'Content-Type': 'application/json' }, body })
    while (window.strandline.session.now.standing.revision === revision) await new Promise((resolve) => setTimeout(resolve, 50))
  }, side)
}

const browser = await startBrowser()
const made = mkdtempSync(join(tmpdir(), 'strandline-bench-'))
for (const wish of process.argv.slice(2)) {
  const file = /^\d+$/.test(wish) ? join(made, `strewn-${wish}.svg`) : wish
  if (file !== wish) writeFileSync(file, strewn(Number(wish)))
  const folder = tempFolder()
  const server = await startServer(folder.path, file)
  const page = await openEditor(browser, server.url)
  if (file !== wish) await makeRoom(page, Number(wish))
  await settled(page, 0, 900000)
  const times = await page.evaluate(async () => {
    const { session } = window.strandline
    const { id } = session.now.standing
    const lines = session.now.drawing.elements.filter((e) => e.kind === 'line')
    const list = []
    for (let i = 0; i < 9; i++) {
      await new Promise((resolve) => setTimeout(resolve, 1200))
      const { revision } = session.now.standing
      const element = lines[i % lines.length]
      const direction = element.closed ? ['ccw', 'cw'][i % 2] : ['forward', 'backward'][i % 2]
      const shown = new Promise((resolve) => {
        const stop = session.listen((now) => {
          if (now.planned <= revision) return
          stop()
          requestAnimationFrame(() => setTimeout(resolve, 0))
        })
      })
      const from = performance.now()
      const body = JSON.stringify({ revision, what: 'turn', changes: [{ edit: { edit: 'direction', element: element.id, direction } }] })
      await fetch(`/api/v1/projects/${id}/edits`, { method: 'POST', headers: { 'Content-Type': 'application/json' }, body })
      const answered = performance.now() - from
      await shown
      list.push([performance.now() - from, answered])
    }
    const sorted = (k) => list.map((t) => Math.round(t[k])).sort((a, b) => a - b)
    const median = (k) => sorted(k)[list.length >> 1]
    return { elements: session.now.drawing.elements.length, answered: median(1), shown: median(0), slowest: sorted(0).at(-1) }
  })
  console.log(JSON.stringify({ load: loadavg()[0], drawing: file.split('/').pop(), ...times }))
  await page.context().close()
  await server.kill()
  folder.remove()
}
await browser.close()
rmSync(made, { recursive: true })
