// Hands without keys, and pages of a tablet's size.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { join } from 'node:path'
import { at, edited, openEditor, root, settled, standing, startBrowser, startServer, tempFolder } from './editor.mjs'

let browser, server, folder, page
const touch = { hasTouch: true, isMobile: true }
before(async () => {
  browser = await startBrowser()
  folder = tempFolder()
  server = await startServer(folder.path, join(root, 'web/tests/drawing.svg'))
  page = await openEditor(browser, server.url, { width: 768, height: 1024 }, touch)
  await settled(page)
})
after(async () => {
  await browser.close()
  await server.kill()
  folder.remove()
  assert.deepEqual(page.faults, [])
})
const tool = async (name) => {
  await page.evaluate((t) => window.strandline.view.set({ tool: t, selected: '' }), name)
  await page.waitForTimeout(60)
}
const tap = async (x, y) => {
  const p = await at(page, x, y)
  await page.touchscreen.tap(p.x, p.y)
}
const button = (name) => page.locator('.foot').getByRole('button', { name })

test('hints speak of taps where there is a finger, and of no keys', async () => {
  for (const name of ['select', 'link', 'shape', 'start', 'end', 'entry', 'fill', 'cut', 'field', 'draw', 'text', 'erase']) {
    await tool(name)
    const hint = await page.locator('.hint').textContent()
    assert.doesNotMatch(hint, /click|escape|delete|enter closes|space/i, name)
    assert.ok(hint.length > 20, name)
  }
  const desk = await openEditor(browser, server.url)
  await desk.keyboard.press('c')
  assert.match(await desk.locator('.hint').textContent(), /^Click the node/)
  await desk.context().close()
})

test('what Escape, Enter and Delete do is done by buttons', async () => {
  await tool('field')
  await page.evaluate(() => window.strandline.stage.fit())
  for (const corner of [[2, 2], [6, 2], [6, 5]]) await tap(...corner)
  await button('Cancel').click()
  assert.equal(await page.locator('.foot button').count(), 0)
  for (const corner of [[2, 2], [6, 2], [6, 5]]) await tap(...corner)
  const fenced = await edited(page, () => button('Close it').click())
  assert.equal(fenced.settings['field.keep_out'].split(' ').length, 3)

  await tool('link')
  const [node] = await page.evaluate(() => {
    const { drive, drawing } = window.strandline.session.now
    const e = drawing.elements[drive.strokes[0].element]
    return [[e.points[0], e.points[1]]]
  })
  await tap(...node)
  await button('Cancel').click()
  assert.match(await page.locator('.hint').textContent(), /^Tap the node where an element is left/)

  await tool('select')
  await page.evaluate(() => window.strandline.view.set({ selected: 'mast', panelOpen: false }))
  await button('Let go').click()
  assert.equal(await page.evaluate(() => window.strandline.view.now.selected), '')
  await page.evaluate(() => window.strandline.view.set({ selected: 'mast' }))
  const erased = await edited(page, () => button('Delete').click())
  assert.equal(erased.edits.length, 1)
  await page.evaluate(() => window.strandline.view.set({ panelOpen: true }))
})

test('tool options stand in one row, in sight', async () => {
  for (const [width, height] of [[768, 1024], [820, 1180], [1024, 768], [1280, 800], [390, 780]]) {
    await page.setViewportSize({ width, height })
    for (const name of ['fill', 'field', 'draw', 'text']) {
      await tool(name)
      const { box, view, rows, hidden } = await page.evaluate(() => {
        const options = document.querySelector('.options')
        const tops = new Set([...options.querySelectorAll('select, input, textarea')].map((e) => Math.round(e.getBoundingClientRect().top / 6)))
        const { left, right, height } = options.getBoundingClientRect()
        const { left: from, right: to } = document.querySelector('.view').getBoundingClientRect()
        return { box: { left, right, height }, view: { left: from, right: to }, rows: tops.size, hidden: options.scrollWidth - options.clientWidth }
      })
      const where = `${name} at ${width} x ${height}`
      assert.equal(rows, 1, where)
      assert.ok(box.height < 80, `${where}: ${box.height} px high`)
      assert.ok(box.left >= view.left && box.right <= view.right, where)
      // On a phone the row is pushed along.
      if (width > 720) assert.ok(hidden <= 0, `${where}: ${hidden} px hidden`)
    }
  }
})
