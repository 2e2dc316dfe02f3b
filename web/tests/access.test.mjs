// For everybody: axe-core finds nothing serious, on a laptop, a tablet and a phone.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { openEditor, pictures, root, settled, startBrowser, startServer, tempFolder } from './editor.mjs'

let browser, server, folder
const axe = readFileSync(join(root, 'web/node_modules/axe-core/axe.min.js'), 'utf8')
before(async () => {
  browser = await startBrowser()
  folder = tempFolder()
  server = await startServer(folder.path, join(root, 'drawings/starfish.svg'))
})
after(async () => {
  await browser.close()
  await server.kill()
  folder.remove()
})

for (const [name, size, options] of [
  ['laptop', { width: 1280, height: 800 }, {}],
  ['tablet', { width: 820, height: 1180 }, { hasTouch: true }],
  ['phone', { width: 390, height: 780 }, { hasTouch: true }],
])
  test(`axe-core has no serious findings on a ${name}`, async () => {
    const page = await openEditor(browser, server.url, size, options)
    await settled(page)
    await page.evaluate(axe)
    for (const [tab, tool] of [['plan', 'fill'], ['order', 'field'], ['settings', 'text'], ['changes', 'draw']]) {
      await page.evaluate(([t, name]) => window.strandline.view.set({ tab: t, panelOpen: true, tool: name, selected: 'arm1' }), [tab, tool])
      await page.waitForTimeout(80)
      const { violations } = await page.evaluate(() => window.axe.run())
      const serious = violations.filter((v) => v.impact === 'serious' || v.impact === 'critical')
      assert.deepEqual(serious.map((v) => [v.id, v.nodes[0].html, v.nodes[0].failureSummary]), [], tab)
      assert.ok(!violations.some((v) => v.id === 'page-has-heading-one'), 'the page has a heading')
    }
    const wider = await page.evaluate(() => document.documentElement.scrollWidth > window.innerWidth)
    assert.ok(!wider, 'nothing is wider than the page')
    await page.evaluate(() => window.strandline.view.set({ tab: 'plan', tool: 'select', selected: '', panelOpen: window.innerWidth > 720 }))
    await page.waitForTimeout(250)
    if (pictures && name === 'tablet') await page.screenshot({ path: join(pictures, `editor-${name}.png`) })
    await page.context().close()
  })

test('all tools are in sight without scrolling', async () => {
  const page = await openEditor(browser, server.url)
  for (const [width, height] of [[1280, 800], [1280, 720], [1024, 640], [820, 1180], [768, 1024], [390, 780]]) {
    await page.setViewportSize({ width, height })
    for (const panelOpen of [true, false]) {
      await page.evaluate((open) => window.strandline.view.set({ panelOpen: open }), panelOpen)
      await page.waitForTimeout(50)
      const hidden = await page.$eval('.rail', (rail) => rail.scrollHeight - rail.clientHeight)
      assert.ok(hidden <= 0, `${hidden} px hidden at ${width} x ${height}, panel ${panelOpen ? 'open' : 'closed'}`)
    }
  }
  await page.context().close()
})

test('every control is reached by the keyboard and shows it', async () => {
  const page = await openEditor(browser, server.url)
  await settled(page)
  const seen = new Set()
  for (let i = 0; i < 60; i++) {
    await page.keyboard.press('Tab')
    const focused = await page.evaluate(() => {
      const e = document.activeElement
      const style = getComputedStyle(e)
      return { name: e.getAttribute('aria-label') ?? e.textContent, outline: style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) >= 2 }
    })
    if (focused.name?.length > 200 || !focused.name) continue
    seen.add(focused.name)
    assert.ok(focused.outline, `focus is seen on ${focused.name}`)
  }
  for (const name of ['Select', 'Draw', 'Outline', 'Play', 'Time', 'Plan', 'Settings']) assert.ok([...seen].some((s) => s.startsWith(name)), name)
  await page.context().close()
})
