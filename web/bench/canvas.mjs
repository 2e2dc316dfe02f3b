// How long the canvas takes with 100,000 segments in headless Chromium: a full redraw, a frame of a gesture, a pick.
// STRANDLINE_PROGRAM=... node bench/canvas.mjs [SEGMENTS]
import { loadavg } from 'node:os'
import { join } from 'node:path'
import { openEditor, root, settled, startBrowser, startServer, tempFolder } from '../tests/editor.mjs'

const wanted = Number(process.argv[2] ?? 100000)
const browser = await startBrowser()
const folder = tempFolder()
const server = await startServer(folder.path, join(root, 'web/tests/drawing.svg'))
const page = await openEditor(browser, server.url)
await settled(page)
const system = await browser.newBrowserCDPSession()
/** Milliseconds of processors, in all of the browser: fair where others use the machine too. */
const cpu = async () => (await system.send('SystemInfo.getProcessInfo')).processInfo.reduce((sum, p) => sum + 1000 * p.cpuTime, 0)
await page.evaluate(async (segments) => {
  const { session, stage, view } = window.strandline
  const lines = segments / 100
  const n = lines * 101
  let seed = 7
  const random = () => (seed = (Math.imul(seed, 1103515245) + 12345) >>> 0) / 2 ** 32
  const zeros = (Type) => new Type(n)
  const samples = { count: n, t: zeros(Float32Array), x: zeros(Float32Array), y: zeros(Float32Array), heading: zeros(Float32Array), rakeX: zeros(Float32Array), rakeY: zeros(Float32Array), mask: zeros(Uint32Array), stroke: zeros(Int32Array), motion: zeros(Uint8Array) }
  const elements = []
  const runs = []
  const strokes = []
  for (let k = 0, i = 0; k < lines; k++) {
    let [x, y, way] = [14 * random(), 14 * random(), 6.28 * random()]
    const points = []
    for (let j = 0; j <= 100; j++, i++) {
      way += 0.8 * (random() - 0.5) + 0.1
      x += 0.01 * Math.cos(way)
      y += 0.01 * Math.sin(way)
      points.push(x, y)
      samples.t[i] = i
      samples.x[i] = samples.rakeX[i] = x
      samples.y[i] = samples.rakeY[i] = y
      samples.mask[i] = j < 100 ? 8 : 0
      samples.stroke[i] = k
    }
    elements.push({ id: `e${k}`, layer: '', inside: -1, hints: {}, length: 1, kind: 'line', closed: false, pins: 1, points, nodes: points.slice(0, 2) })
    runs.push([i - 101, i - 1, 8, k, 0])
    strokes.push({ element: k, fill: false, closed: false, pins: 1, reversed: false, node: 0, first: i - 101, last: i - 1 })
  }
  const { drive, drawing } = session.now
  view.set({ connections: 'shown', faults: false })
  const begun = performance.now()
  session.set({ drawing: { ...drawing, elements }, drive: { ...drive, strokes, runs, connections: [] }, samples, report: null })
  const taken = performance.now() - begun
  const rest = () => new Promise((resolve) => setTimeout(resolve, 400))
  await rest()
  const pixel = () => document.querySelector('canvas.base').getContext('2d').getImageData(0, 0, 1, 1)
  const stats = (list) => {
    const sorted = [...list].sort((a, b) => a - b)
    return { median: +sorted[sorted.length >> 1].toFixed(2), p95: +sorted[Math.floor(sorted.length * 0.95)].toFixed(2) }
  }
  const times = (count, act) =>
    stats(
      Array.from({ length: count }, () => {
        const from = performance.now()
        act()
        pixel() // drawing is put off until somebody looks
        return performance.now() - from
      }),
    )
  let picked = 0
  window.bench = {
    taken: () => +taken.toFixed(1),
    redraw: () => times(40, () => stage.paintBase()),
    gesture: () => times(60, () => {
      stage.gesture({ ...stage.camera, x: stage.camera.x + 3, scale: stage.camera.scale * 1.005 })
      stage.paintMoved()
    }),
    rest,
    pick: () => {
      const from = performance.now()
      for (let i = 0; i < 2000; i++) picked += stage.picking.element({ x: 14 * random(), y: 14 * random() }, 0.2)
      return { mean: +((performance.now() - from) / 2000).toFixed(4) }
    },
  }
}, wanted)
const figures = {}
for (const [what, count] of [['taken', 1], ['redraw', 40], ['gesture', 60], ['rest', 1], ['pick', 2000]]) {
  const before = await cpu()
  const wall = await page.evaluate((name) => window.bench[name](), what)
  if (what !== 'rest') figures[what] = count === 1 ? wall : { ...wall, cpu: +(((await cpu()) - before) / count).toFixed(3) }
}
console.log(JSON.stringify({ segments: wanted, load: loadavg()[0], ms: figures }))
await browser.close()
await server.kill()
folder.remove()
