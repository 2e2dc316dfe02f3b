// Projects: upload, export, save, reload, two tabs, a server that was killed.
import assert from 'node:assert/strict'
import { after, afterEach, before, beforeEach, test } from 'node:test'
import { readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { drag, edited, elements, openEditor, root, settled, standing, startBrowser, startServer, tempFolder } from './editor.mjs'

let browser, server, folder, page
before(async () => (browser = await startBrowser()))
after(() => browser.close())
beforeEach(async () => {
  folder = tempFolder()
  server = await startServer(folder.path, join(root, 'web/tests/drawing.svg'))
  page = await openEditor(browser, server.url)
  await settled(page)
})
afterEach(async () => {
  assert.deepEqual(page.faults, [])
  await page.context().close()
  await server.kill()
  folder.remove()
})

const eraseMast = (p) =>
  edited(p, async () => {
    await p.evaluate(() => window.strandline.view.set({ selected: 'mast' }))
    await p.getByRole('region', { name: 'Element' }).getByText('Erase').click()
  })

test('what was edited is there again after the server was killed and the page loaded anew', async () => {
  await eraseMast(page)
  const before = await standing(page)
  const { port } = server
  await server.kill('SIGKILL')
  await page.locator('.status.bad').waitFor()
  server = await startServer(folder.path, join(root, 'web/tests/drawing.svg'), port)
  await page.reload()
  await settled(page)
  const now = await standing(page)
  assert.deepEqual([now.revision, now.edits], [before.revision, before.edits])
  await edited(page, () => page.click('button[aria-label^="undo"]'))
  assert.deepEqual((await standing(page)).edits, [])
})

test('a page that stays open goes on when the server is back', async () => {
  const { port } = server
  await server.kill('SIGKILL')
  await page.locator('.status.bad').waitFor()
  server = await startServer(folder.path, join(root, 'web/tests/drawing.svg'), port)
  await page.waitForFunction(() => window.strandline.session.now.online, null, { timeout: 20000 })
  await eraseMast(page)
  assert.equal((await standing(page)).edits.length, 1)
})

test('two tabs show the same project; a stale edit is taken up again', async () => {
  const other = await openEditor(browser, server.url)
  await settled(other)
  await eraseMast(page)
  await other.waitForFunction(() => !window.strandline.session.now.drawing.elements.some((e) => e.id === 'mast'))
  await other.keyboard.press('d')
  await edited(other, () => drag(other, [[2, 11], [5, 12], [6, 11]]))
  await page.waitForFunction(() => window.strandline.session.now.drawing.elements.some((e) => e.id === 'pen1'))
  assert.equal((await standing(page)).edits.length, 2)
  // A revision that is no longer the newest: the page takes over what is new, then edits once more.
  await page.evaluate(() => {
    const { session } = window.strandline
    session.set({ standing: { ...session.now.standing, revision: 1 } })
  })
  await page.keyboard.press('d')
  await drag(page, [[2, 9], [3, 10], [4, 9]])
  await page.waitForFunction(() => window.strandline.session.now.standing.edits.length === 3)
  // Not even that a line of that name was drawn: it does not take its place.
  await settled(page, 4)
  await page.evaluate(() => {
    const { session } = window.strandline
    const { standing, drawing } = session.now
    const elements = drawing.elements.filter((e) => !e.id.startsWith('pen'))
    session.set({ standing: { ...standing, revision: 1, edits: [] }, drawing: { ...drawing, elements } })
  })
  await drag(page, [[2, 8], [3, 9], [4, 8]])
  await page.locator('.hint.notice').filter({ hasText: '"draw pen1" is lost' }).waitFor()
  const kept = (await standing(page)).edits.filter((e) => e.edit === 'draw')
  assert.deepEqual(kept.map((e) => [e.element, Math.round(e.paths[0][2])]), [['pen1', 11], ['pen2', 9]])
  await other.context().close()
})

test('an answer that was overtaken by a newer event does not take its place', async () => {
  // What the server said while it was planning comes when it has long been done.
  let held = 0
  await page.route(/projects\/drawing$/, async (route) => {
    if (route.request().method() !== 'GET' || held > 0) return route.continue()
    held++
    const response = await route.fetch()
    await page.waitForFunction(() => window.strandline.session.now.report !== null && !window.strandline.session.now.planning, null, { timeout: 2000 }).catch(() => {})
    await new Promise((done) => setTimeout(done, 1500))
    await route.fulfill({ response })
  })
  await eraseMast(page)
  assert.equal(held, 1)
  assert.equal(await page.evaluate(() => window.strandline.session.now.planning), false)
})

test('a robot of one\'s own is taken by its profile, and a wrong one is refused', async () => {
  await page.click('role=tab[name="Settings"]')
  await page.click('summary:has-text("Robot")')
  const profile = (text) => ({ name: 'mine.toml', mimeType: 'text/plain', buffer: Buffer.from(text) })
  const now = await edited(page, () => page.setInputFiles('input[aria-label="Robot profile"]', profile('base = "turf"\nname = "mine"\nmin_radius = 0.8\n')))
  assert.deepEqual([now.robot_name, now.robot.min_radius], ['mine', 0.8])
  assert.equal(await page.inputValue('#set-robot'), '')
  await page.setInputFiles('input[aria-label="Robot profile"]', profile('min_radius = -1'))
  await page.getByRole('status').getByText('min_radius').waitFor()
  assert.equal((await standing(page)).robot_name, 'mine')
  const back = await edited(page, () => page.selectOption('#set-robot', 'beachbot'))
  assert.deepEqual([back.robot_name, back.set], ['beachbot', ['robot']])
})

test('SVG and PNG are opened and dropped, each a project of its own', async () => {
  const svg = join(root, 'drawings/hello.svg')
  await page.click('text=Project')
  await page.setInputFiles('input[type=file] >> nth=0', svg)
  await page.waitForFunction(() => window.strandline.session.now.standing.id === 'hello')
  await settled(page)
  assert.ok((await elements(page)).length > 3)
  const png = await page.evaluate(async () => {
    const canvas = new OffscreenCanvas(200, 200)
    const ctx = canvas.getContext('2d')
    ctx.fillStyle = '#fff'
    ctx.fillRect(0, 0, 200, 200)
    ctx.fillStyle = '#000'
    ctx.fillRect(40, 40, 120, 120)
    const bytes = new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer())
    const transfer = new DataTransfer()
    transfer.items.add(new File([bytes], 'square.png', { type: 'image/png' }))
    document.querySelector('.app').dispatchEvent(new DragEvent('drop', { dataTransfer: transfer, bubbles: true, cancelable: true }))
    return bytes.length
  })
  assert.ok(png > 0)
  await page.waitForFunction(() => window.strandline.session.now.standing.id === 'square')
  await settled(page)
  assert.equal((await elements(page))[0].kind, 'region')
  await page.click('text=Project')
  await page.locator('.sheet').getByRole('button', { name: 'drawing', exact: true }).click()
  await page.waitForFunction(() => window.strandline.session.now.standing.id === 'drawing')
})

test('another drawing takes the place of this one, and undo brings it back', async () => {
  await page.click('text=Project')
  await edited(page, () => page.setInputFiles('input[type=file] >> nth=1', join(root, 'drawings/hello.svg')))
  assert.equal((await standing(page)).id, 'drawing')
  assert.ok(!(await elements(page)).some((e) => e.id === 'mast'))
  await edited(page, () => page.click('button[aria-label^="undo"]'))
  assert.ok((await elements(page)).some((e) => e.id === 'mast'))
})

test('what is no drawing is refused in words', async () => {
  const wrong = join(folder.path, 'notes.txt')
  writeFileSync(wrong, 'no drawing')
  await page.click('text=Project')
  await page.setInputFiles('input[type=file] >> nth=0', wrong)
  await page.locator('.hint.notice').filter({ hasText: 'neither SVG nor PNG' }).waitFor()
  const empty = join(folder.path, 'empty.png')
  writeFileSync(empty, '')
  await page.click('text=Project')
  await page.setInputFiles('input[type=file] >> nth=0', empty)
  await page.locator('.hint.notice').filter({ hasText: 'empty.png is empty' }).waitFor()
  assert.equal((await standing(page)).id, 'drawing')
})

test('the project is saved as a file and opened again with its edits', async () => {
  await eraseMast(page)
  await page.click('text=Project')
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('text=Save a copy')])
  const copy = join(folder.path, 'mine.json')
  await download.saveAs(copy)
  await page.click('text=Project')
  await page.setInputFiles('input[type=file] >> nth=0', copy)
  await page.waitForFunction(() => window.strandline.session.now.standing.id === 'mine')
  await settled(page)
  assert.equal((await standing(page)).edits.length, 1)
})

async function exported(format) {
  await page.click('text=Export')
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.locator('.sheet button.row').filter({ has: page.locator(`b:text-is("${format}")`) }).click(),
  ])
  return download
}

test('every export is a file with something in it', async () => {
  const formats = await page.evaluate(() => window.strandline.session.now.about.exports.map((e) => e.name))
  assert.ok(formats.length >= 6)
  for (const format of formats) {
    const download = await exported(format)
    assert.ok(readFileSync(await download.path()).length > 100, format)
    await page.keyboard.press('Escape')
  }
})

test('what an export takes for granted is said where it is saved', async () => {
  const download = await exported('geojson')
  assert.equal(download.suggestedFilename(), 'drawing.geojson')
  const said = page.getByRole('region', { name: 'Saved' })
  await said.getByText('latitude 0, longitude 0 is taken').waitFor()
  assert.match(await said.textContent(), /^drawing.geojson is saved, with 1 warning:/)
  await page.locator('.sheet').waitFor({ state: 'detached' })
  await page.keyboard.press('Escape')
  await said.waitFor({ state: 'detached' })
  // Nothing to say: the list is gone with the file.
  await exported('csv')
  await page.locator('.sheet').waitFor({ state: 'detached' })
})

test('Escape closes a list and leaves the tool in hand', async () => {
  await page.keyboard.press('d')
  await page.click('text=Export')
  await page.locator('.sheet').waitFor()
  await page.keyboard.press('Escape')
  await page.locator('.sheet').waitFor({ state: 'detached' })
  assert.equal(await page.evaluate(() => window.strandline.view.now.tool), 'draw')
  assert.equal(await page.evaluate(() => document.activeElement.getAttribute('aria-label')), 'Export')
})

test('an export that is refused is said in words, and no file comes', async () => {
  await page.route(/exports\/csv$/, (route) =>
    route.fulfill({ status: 409, json: { error: { code: 'refused', place: 'plan', reason: 'is still being made', remedy: 'wait a moment' } } }),
  )
  await page.click('text=Export')
  await page.locator('.sheet button.row').filter({ has: page.locator('b:text-is("csv")') }).click()
  await page.locator('.hint.notice').filter({ hasText: 'plan: is still being made; wait a moment' }).waitFor()
  assert.ok(await page.locator('.sheet button.row').first().isEnabled())
})

test('a sketch begins on bare sand and is drawn by hand', async () => {
  await page.click('text=Project')
  await page.click('text=New sketch')
  await page.waitForFunction(() => window.strandline.session.now.standing.id === 'sketch')
  await settled(page)
  // Nothing is wrong with it: it is told what to begin with.
  assert.equal(await page.locator('.status').textContent(), 'bare sand')
  assert.equal(await page.getByRole('alert').count() + await page.locator('.bad').count(), 0)
  await page.getByText('Bare sand: nothing is drawn yet. Draw with the pen').waitFor()
  await page.locator('.hint').filter({ hasText: 'Bare sand: draw with the pen' }).waitFor()
  await page.locator('.panel').getByRole('button', { name: 'Draw' }).click()
  assert.equal(await page.evaluate(() => window.strandline.view.now.tool), 'draw')
  const box = await page.locator('.canvas').boundingBox()
  const now = await edited(page, async () => {
    await page.mouse.move(box.x + 200, box.y + 300)
    await page.mouse.down()
    await page.mouse.move(box.x + 500, box.y + 200, { steps: 8 })
    await page.mouse.up()
  })
  assert.equal(now.failure, null)
  assert.equal((await elements(page)).length, 1)
  // Without its only line it is bare again, and nothing of the line is left.
  await edited(page, () => page.click('button[aria-label^="undo"]'))
  await page.waitForFunction(() => window.strandline.session.now.drawing.elements.length === 0)
  assert.equal(await page.evaluate(() => window.strandline.session.now.drive), null)
  await page.getByText('Bare sand: nothing').waitFor()
  await edited(page, () => page.click('button[aria-label^="redo"]'))
  assert.equal((await elements(page)).length, 1)
})

test('a broken drawing, or one without shapes, is refused with its place and becomes no project', async () => {
  const refused = async (name, text, why) => {
    const path = join(folder.path, name)
    writeFileSync(path, text)
    await page.click('text=Project')
    await page.setInputFiles('input[type=file] >> nth=0', path)
    await page.locator('.hint.notice').filter({ hasText: why }).waitFor()
  }
  await refused('torn.svg', '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0', 'torn.svg, line 1')
  await refused('bare.svg', '<svg xmlns="http://www.w3.org/2000/svg"><g/></svg>', 'bare.svg: holds no shapes')
  assert.equal((await standing(page)).id, 'drawing')
  assert.deepEqual(readdirSync(folder.path).filter((name) => name.endsWith('.strandline')), ['drawing.strandline'])
  assert.ok((await elements(page)).length > 3, 'what was open is open still')
})

const projectRow = (name) => page.locator('.sheet').getByRole('button', { name, exact: true })
const opened = (p, id) => p.waitForFunction((wanted) => window.strandline.session.now.standing.id === wanted, id)
const files = () => readdirSync(folder.path).filter((name) => name.endsWith('.strandline')).sort()

test('a project is deleted from the list once it was asked for, and pages that have it open go to another', async () => {
  await page.click('text=Project')
  await page.click('text=New sketch')
  await opened(page, 'sketch')
  const other = await openEditor(browser, page.url())
  await opened(other, 'sketch')
  await page.click('text=Project')
  await projectRow('Delete sketch').click()
  const asked = page.getByRole('group', { name: 'Delete sketch?' })
  await asked.getByRole('button', { name: 'Keep' }).click()
  await asked.waitFor({ state: 'detached' })
  assert.deepEqual(files(), ['drawing.strandline', 'sketch.strandline'])
  await projectRow('Delete sketch').click()
  await asked.getByRole('button', { name: 'Delete' }).click()
  await opened(page, 'drawing')
  assert.deepEqual(files(), ['drawing.strandline'])
  await page.locator('.hint').filter({ hasText: 'sketch is deleted' }).waitFor()
  await opened(other, 'drawing')
  await other.locator('.hint').filter({ hasText: 'sketch was deleted' }).waitFor()
  await settled(other)
  assert.equal(await other.locator('.status').textContent(), 'saved')
  await other.context().close()
})

test('a notice ends with its project', async () => {
  await page.click('text=Project')
  await page.click('text=New sketch')
  await opened(page, 'sketch')
  await page.click('text=Project')
  await page.setInputFiles('input[type=file] >> nth=0', { name: 'notes.txt', mimeType: 'text/plain', buffer: Buffer.from('no drawing') })
  await page.locator('.hint.notice').waitFor()
  await page.click('text=Project')
  await projectRow('drawing').click()
  await opened(page, 'drawing')
  assert.equal(await page.locator('.hint.notice').count(), 0)
})
