// A server in a folder of its own and a browser on it: what every test begins with.
import assert from 'node:assert/strict'
import { spawn } from 'node:child_process'
import { copyFileSync, mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { basename, join } from 'node:path'
import { after, before, beforeEach } from 'node:test'
import { fileURLToPath } from 'node:url'
import { chromium } from 'playwright-core'

export const root = fileURLToPath(new URL('../..', import.meta.url))
const program = process.env.STRANDLINE_PROGRAM ?? join(root, 'build/release/apps/cli/strandline')
export const pictures = process.env.STRANDLINE_PICTURES ?? ''

export function tempFolder() {
  const path = mkdtempSync(join(tmpdir(), 'strandline-web-'))
  return { path, remove: () => rmSync(path, { recursive: true, force: true }) }
}

/** strandline serve; `url` is what it prints. */
export function startServer(folder, drawing, port = 0) {
  const copy = drawing ? join(folder, basename(drawing)) : ''
  if (drawing) copyFileSync(drawing, copy)
  const child = spawn(program, ['serve', ...(copy ? [copy] : []), '--folder', folder, '--port', String(port)])
  return new Promise((resolve, reject) => {
    let said = ''
    child.stdout.on('data', (data) => {
      said += data
      const end = said.indexOf('\n')
      if (end < 0) return
      const url = said.slice(0, end)
      resolve({ url, port: Number(new URL(url).port), child, kill: (how = 'SIGTERM') => ended(child, how) })
    })
    child.on('exit', (code) => reject(new Error(`the server ended with ${code}`)))
  })
}
function ended(child, how) {
  if (child.exitCode !== null || child.signalCode !== null) return Promise.resolve()
  return new Promise((resolve) => {
    child.removeAllListeners('exit')
    child.on('exit', resolve)
    child.kill(how)
  })
}

export function startBrowser() {
  return chromium.launch({
    executablePath: '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'],
  })
}

/** The newest change is planned, checked and on the screen. */
export function settled(page, revision = 0, timeout = 60000) {
  return page.waitForFunction(
    (least) => {
      const s = window.strandline?.session.now
      if (!s?.standing || s.standing.revision < least || s.planning) return false
      return s.failure !== null || (s.report !== null && s.planned === s.standing.revision)
    },
    revision,
    { timeout },
  )
}

/** A page of the editor; what it logs as an error fails the test. */
export async function openEditor(browser, url, size = { width: 1280, height: 800 }, options = {}) {
  const context = await browser.newContext({ viewport: size, acceptDownloads: true, ...options })
  const page = await context.newPage()
  page.faults = []
  page.foreign = []
  page.on('pageerror', (error) => page.faults.push(error.message))
  page.on('request', (request) => {
    if (!request.url().startsWith(new URL(url).origin) && !request.url().startsWith('data:') && !request.url().startsWith('blob:')) page.foreign.push(request.url())
  })
  await page.goto(url)
  await page.waitForFunction(() => window.strandline?.session.now.standing)
  return page
}

/** One page with web/tests/drawing.svg for all tests of a file, handed to `take`; each test begins with nothing changed. */
export function onePage(take) {
  let browser, server, folder, page
  before(async () => {
    browser = await startBrowser()
    folder = tempFolder()
    server = await startServer(folder.path, join(root, 'web/tests/drawing.svg'))
    take((page = await openEditor(browser, server.url)))
    await settled(page)
  })
  after(async () => {
    await browser.close()
    await server.kill()
    folder.remove()
    assert.deepEqual(page.faults, [])
    assert.deepEqual(page.foreign, [], 'no request leaves the machine')
  })
  beforeEach(async () => {
    await page.keyboard.press('Escape')
    await page.evaluate(() => window.strandline.view.set({ selected: '', tab: 'plan', time: null }))
    while ((await standing(page)).undo.count > 0) await edited(page, () => page.click('button[aria-label^="undo"]'))
  })
}

export const standing = (page) => page.evaluate(() => window.strandline.session.now.standing)
export const elements = (page) => page.evaluate(() => window.strandline.session.now.drawing.elements)
export const view = (page) => page.evaluate(() => window.strandline.view.now)

/** Metres on the canvas -> where the mouse has to be. */
export async function at(page, x, y) {
  return page.evaluate(
    ([wx, wy]) => {
      const { stage } = window.strandline
      const box = stage.host.getBoundingClientRect()
      return { x: box.left + stage.camera.x + wx * stage.camera.scale, y: box.top + stage.camera.y - wy * stage.camera.scale }
    },
    [x, y],
  )
}
export async function click(page, x, y) {
  const p = await at(page, x, y)
  await page.mouse.move(p.x, p.y)
  await page.mouse.click(p.x, p.y)
}
export async function drag(page, points) {
  const first = await at(page, ...points[0])
  await page.mouse.move(first.x, first.y)
  await page.mouse.down()
  for (const point of points.slice(1)) {
    const p = await at(page, ...point)
    await page.mouse.move(p.x, p.y, { steps: 4 })
  }
  await page.mouse.up()
}
/** What `act` does is one step more; waits until that is planned. */
export async function edited(page, act) {
  const before = (await standing(page)).revision
  await act()
  await page.waitForFunction((r) => window.strandline.session.now.standing.revision > r, before)
  await settled(page, before + 1)
  return standing(page)
}

/** How many of the base canvas's pixels are that dark, between 0 and 1: whether something was painted. */
export function darkShare(page, below = 110) {
  return page.evaluate((limit) => {
    const canvas = document.querySelector('canvas.base')
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height)
    let dark = 0
    for (let i = 0; i < data.length; i += 4) if (data[i] < limit) dark++
    return dark / (data.length / 4)
  }, below)
}
