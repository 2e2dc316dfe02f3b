// The server is away: one edit waits for it, and what is not kept does not stay on the canvas.
import assert from 'node:assert/strict'
import { after, afterEach, before, beforeEach, test } from 'node:test'
import { join } from 'node:path'
import { drag, openEditor, root, settled, standing, startBrowser, startServer, tempFolder } from './editor.mjs'

let browser, server, folder, page
before(async () => (browser = await startBrowser()))
after(() => browser.close())
beforeEach(async () => {
  folder = tempFolder()
  server = await startServer(folder.path, join(root, 'web/tests/drawing.svg'))
  page = await openEditor(browser, server.url)
  await settled(page)
  await page.keyboard.press('d')
})
afterEach(async () => {
  assert.deepEqual(page.faults, [])
  await page.context().close()
  await server.kill()
  folder.remove()
})

const foot = (text) => page.locator('.hint').filter({ hasText: text })
const pens = async () => (await standing(page)).edits.map((e) => e.element)
/** Pixels of the tool's canvas that hold anything. */
const painted = () =>
  page.evaluate(async () => {
    await new Promise(requestAnimationFrame)
    await new Promise(requestAnimationFrame)
    const canvas = document.querySelector('canvas.layer:not(.base)')
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height)
    let some = 0
    for (let i = 3; i < data.length; i += 4) if (data[i] > 0) some++
    return some
  })
const line = () => drag(page, [[2, 11], [5, 12], [6, 11]])
const back = async () => (server = await startServer(folder.path, join(root, 'web/tests/drawing.svg'), server.port))

test('a line drawn while the server is away stays in sight, waits, and is kept when it is back', async () => {
  await server.kill('SIGKILL')
  await page.locator('.status.bad').waitFor()
  const bare = await painted()
  await line()
  await foot('"draw pen1" waits here and is sent').waitFor()
  assert.ok((await painted()) > bare + 100, 'the line is in sight')
  await back()
  await foot('The server is back, and "draw pen1" is kept').waitFor({ timeout: 20000 })
  await page.waitForFunction(() => window.strandline.session.now.drawing.elements.some((e) => e.id === 'pen1'), null, { timeout: 20000 })
  assert.deepEqual(await pens(), ['pen1'])
  await foot('waits here').waitFor({ state: 'detached' })
})

test('one edit waits at most: another is taken off the canvas and said to be lost, and the first can be dropped', async () => {
  await server.kill('SIGKILL')
  await page.locator('.status.bad').waitFor()
  const bare = await painted()
  await line()
  await foot('waits here').waitFor()
  const one = await painted()
  await drag(page, [[2, 2], [5, 1], [12, 2]])
  await foot('"draw pen2" is not kept').waitFor()
  assert.ok(Math.abs((await painted()) - one) < 50, 'the second line is gone')
  await page.getByRole('button', { name: 'Drop it' }).click()
  await foot('"draw pen1" was dropped').waitFor()
  assert.ok(Math.abs((await painted()) - bare) < 50, 'so is the first')
  await back()
  await page.waitForFunction(() => window.strandline.session.now.online, null, { timeout: 20000 })
  assert.deepEqual(await pens(), [])
})

test('a setting that is refused while an edit waits goes back to what holds', async () => {
  await page.click('role=tab[name="Settings"]')
  await server.kill('SIGKILL')
  await page.locator('.status.bad').waitFor()
  await line()
  await foot('waits here').waitFor()
  await page.click('summary:has-text("Filling")')
  const list = page.locator('[id="set-fill.style"]')
  const held = await list.inputValue()
  await list.selectOption({ index: (await list.locator('option').count()) - 1 })
  await foot('is not kept').waitFor()
  await page.waitForFunction((value) => document.getElementById('set-fill.style').value === value, held)
})

test('an edit whose answer alone was lost is not sent twice', async () => {
  await page.route(/\/edits$/, async (route) => {
    await route.fetch()
    await route.abort()
  })
  await line()
  await foot('"draw pen1" is kept').waitFor()
  const now = await standing(page)
  assert.deepEqual([now.undo.count, now.edits.length], [1, 1])
})

test('an edit that waits is not put on top of what others changed meanwhile, and this is said', async () => {
  let away = true
  await page.route(/api\/v1\//, (route) => (away ? route.abort() : route.continue()))
  await line()
  await foot('waits here').waitFor()
  const other = await openEditor(browser, server.url)
  await settled(other)
  await other.keyboard.press('d')
  await drag(other, [[2, 9], [3, 10], [4, 9]])
  await other.waitForFunction(() => window.strandline.session.now.standing.edits.length === 1)
  await other.context().close()
  away = false
  await foot('"draw pen1" is lost: the project was changed elsewhere').waitFor()
  await page.waitForFunction(() => window.strandline.session.now.standing.revision === 2)
  assert.equal((await standing(page)).edits.length, 1)
})
