// How long the canvas takes with 100,000 segments in headless Chromium: a full redraw, a frame of a gesture, a pick.
// STRANDLINE_PROGRAM=... node bench/canvas.mjs [SEGMENTS]
import { join } from 'node:path'
import { openEditor, root, settled, startBrowser, startServer, tempFolder } from '../tests/editor.mjs'

const wanted = Number(process.argv[2] ?? 100000)
const browser = await startBrowser()
const folder = tempFolder()
const server = await startServer(folder.path, join(root, 'web/tests/drawing.svg'))
const page = await openEditor(browser, server.url)
await settled(page)
const figures = await page.evaluate(async (segments) => {
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
  const timed = (act) => {
    const from = performance.now()
    act()
    pixel() // drawing is put off until somebody looks
    return performance.now() - from
  }
  const stats = (list) => {
    const sorted = [...list].sort((a, b) => a - b)
    return { median: +sorted[sorted.length >> 1].toFixed(2), p95: +sorted[Math.floor(sorted.length * 0.95)].toFixed(2) }
  }
  const redraws = Array.from({ length: 15 }, () => timed(() => stage.paintBase()))
  const frames = []
  for (let k = 0; k < 60; k++) {
    stage.gesture({ ...stage.camera, x: stage.camera.x + 3, scale: stage.camera.scale * 1.005 })
    frames.push(timed(() => stage.paintMoved()))
  }
  await rest()
  const picks = Array.from({ length: 2000 }, () => {
    const from = performance.now()
    stage.picking.element({ x: 14 * random(), y: 14 * random() }, 0.2)
    return performance.now() - from
  })
  return { taken: +taken.toFixed(1), redraw: stats(redraws), gesture: stats(frames), pick: { mean: +(picks.reduce((a, b) => a + b) / picks.length).toFixed(4), p95: stats(picks).p95 } }
}, wanted)
console.log(JSON.stringify({ segments: wanted, ms: figures }))
await browser.close()
await server.kill()
folder.remove()
