// Views, playback, panels.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { join } from 'node:path'
import { at, darkShare, edited, openEditor, pictures, root, settled, standing, startBrowser, startServer, tempFolder, view } from './editor.mjs'

let browser, server, folder, page
before(async () => {
  browser = await startBrowser()
  folder = tempFolder()
  server = await startServer(folder.path, join(root, 'drawings/lighthouse.svg'))
  page = await openEditor(browser, server.url)
  await settled(page)
})
after(async () => {
  assert.deepEqual(page.faults, [])
  await browser.close()
  await server.kill()
  folder.remove()
})
const set = async (part) => {
  await page.evaluate((p) => window.strandline.view.set(p), part)
  await page.waitForTimeout(120)
}
const picture = async (name) => pictures && page.screenshot({ path: join(pictures, `editor-${name}.png`) })
const pixels = () =>
  page.evaluate(() => {
    const canvas = document.querySelector('canvas.base')
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height)
    let sum = 0
    for (let i = 0; i < data.length; i += 4) sum = (Math.imul(sum, 31) + data[i] * 3 + data[i + 1] * 5 + data[i + 2] * 7) | 0
    return sum
  })

test('each view is another picture of the same drive', async () => {
  await page.waitForTimeout(200)
  const seen = new Set([await pixels()])
  await picture('outline')
  for (const part of [
    { connections: 'arrows' },
    { connections: 'hidden' },
    { orderColours: true },
    { wheels: true },
    { grid: false },
    { wheels: false, orderColours: false, look: 'realistic' },
    { orderColours: true, connections: 'shown' },
  ]) {
    await set(part)
    const now = await pixels()
    assert.ok(!seen.has(now), JSON.stringify(part))
    seen.add(now)
  }
  await set({ look: 'outline', connections: 'hidden', orderColours: true, grid: true })
  await picture('order')
  await set({ look: 'realistic', connections: 'hidden', orderColours: false, faults: false })
  await picture('sand')
  await set({ look: 'outline', connections: 'shown', faults: true })
})

test('the wheel zooms where the pointer is, the right button and space move, 0 shows all', async () => {
  const camera = () => page.evaluate(() => ({ ...window.strandline.stage.camera }))
  const first = await camera()
  const p = await at(page, 4, 4)
  await page.mouse.move(p.x, p.y)
  await page.mouse.wheel(0, -300)
  await page.waitForTimeout(50)
  const near = await camera()
  assert.ok(near.scale > 1.5 * first.scale)
  const still = await at(page, 4, 4)
  assert.ok(Math.hypot(still.x - p.x, still.y - p.y) < 1)
  for (const button of ['right', 'space']) {
    const before = await camera()
    if (button === 'space') await page.keyboard.down('Space')
    await page.mouse.down({ button: button === 'right' ? 'right' : 'left' })
    await page.mouse.move(p.x + 60, p.y + 40, { steps: 3 })
    await page.mouse.up({ button: button === 'right' ? 'right' : 'left' })
    if (button === 'space') await page.keyboard.up('Space')
    const now = await camera()
    assert.ok(Math.abs(now.x - before.x - 60) < 1 && Math.abs(now.y - before.y - 40) < 1, button)
    await page.mouse.move(p.x, p.y)
  }
  await page.locator('.canvas').focus()
  await page.keyboard.press('0')
  assert.deepEqual(await camera(), first)
})

test('playback shows the sand so far, time and metres, and plays on', async () => {
  await page.waitForTimeout(200)
  const all = await darkShare(page)
  await page.locator('input.time').evaluate((slider) => {
    slider.value = String(Number(slider.max) / 4)
    slider.dispatchEvent(new Event('input', { bubbles: true }))
  })
  await page.waitForTimeout(150)
  const some = await darkShare(page)
  assert.ok(some > 0 && some < 0.7 * all, `${some} of ${all}`)
  await picture('playback')
  const { time } = await view(page)
  await page.selectOption('.speed select', '200')
  await page.click('button[aria-label="Play"]')
  await page.waitForTimeout(600)
  await page.click('button[aria-label="Pause"]')
  assert.ok((await view(page)).time > time + 20)
  assert.ok((await darkShare(page)) > some)
  assert.match(await page.textContent('.clock'), /min.*m/)
  await page.click('button[aria-label="Show the whole plan"]')
  await page.waitForTimeout(150)
  assert.ok(Math.abs((await darkShare(page)) - all) < 0.02 * all)
})

test('the list of the order jumps to an element in space and time', async () => {
  await page.click('role=tab[name="Order"]')
  await page.locator('.order .name').nth(3).click()
  const now = await view(page)
  assert.ok(now.selected !== '' && now.time > 0)
  await set({ time: null, selected: '' })
  await page.keyboard.press('Escape')
})

test('findings jump to their place', async () => {
  await page.click('role=tab[name="Plan"]')
  const before = await page.evaluate(() => ({ ...window.strandline.stage.camera }))
  await page.locator('.findings button').first().click()
  assert.notDeepEqual(await page.evaluate(() => ({ ...window.strandline.stage.camera })), before)
  await set({ time: null })
})

test('every setting of the API stands in the panel, with help; one can be set and put back', async () => {
  await page.click('role=tab[name="Settings"]')
  const keys = await page.evaluate(() => window.strandline.session.now.about.settings.map((s) => s.key))
  const fields = await page.evaluate(() => window.strandline.session.now.about.robot_fields.map((f) => `robot.${f.name}`))
  for (const key of [...keys, ...fields]) assert.equal(await page.locator(`[id="set-${key}"]`).count(), 1, key)
  for (const group of new Set(keys.map((key) => key.split('.')[0]))) assert.equal(await page.getByText(group, { exact: true }).count(), 0, group)
  await picture('settings')
  const width = page.locator('[id="set-canvas.width"]')
  let now = await edited(page, async () => {
    await width.fill('1600cm')
    await width.press('Enter')
  })
  assert.equal(Number(now.settings['canvas.width']), 16)
  await page.locator('summary').filter({ hasText: 'Robot' }).click()
  now = await edited(page, () => page.selectOption('#set-robot', 'turf'))
  assert.equal(now.robot.name, 'turf')
  await page.click('role=tab[name="Changes"]')
  now = await edited(page, () => page.click('button[aria-label="Default for canvas.width"]'))
  assert.ok(!now.set.includes('canvas.width'))
  now = await edited(page, () => page.click('button[aria-label="Default for robot"]'))
  assert.equal(now.robot.name, 'beachbot')
})

test('ranges are written as people write numbers', async () => {
  await page.click('role=tab[name="Settings"]')
  const ranges = await page.$$eval('.settings .range', (all) => all.map((e) => e.textContent))
  assert.ok(ranges.some((range) => range.includes('100,000 m')), ranges.join())
  for (const range of ranges) assert.doesNotMatch(range, /\de[-+]?\d|0 to 0 |NaN/, range)
})

test('warnings of the plan name no switch of the command line', async () => {
  // The lighthouse has places that the robot cannot go round: one warning sums them up.
  await page.click('role=tab[name="Plan"]')
  const texts = await page.$$eval('.findings li', (all) => all.map((e) => e.textContent))
  assert.ok(texts.some((text) => /^(avoid.finished|the drive)/.test(text)), texts.join('\n'))
  for (const text of texts) assert.doesNotMatch(text, /\(?-v|--/, text)
})

test('a value that cannot be is refused in words, and nothing changes', async () => {
  await page.click('role=tab[name="Settings"]')
  const { revision } = await standing(page)
  const width = page.locator('[id="set-canvas.width"]')
  await width.fill('blue')
  await width.press('Enter')
  await page.locator('.hint.notice').filter({ hasText: 'canvas.width' }).waitFor()
  assert.equal((await standing(page)).revision, revision)
  await page.waitForFunction(() => document.getElementById('set-canvas.width').value !== 'blue')
})

test('keep-outs are shown; with a drive in and out the shape tool still finds its connections', async () => {
  await set({ look: 'outline', connections: 'shown' })
  const before = await pixels()
  const changes = [
    { set: 'field.keep_out', value: '0.2,0.2 1.2,0.2 0.7,1.2' },
    { set: 'park.x', value: '0' },
    { set: 'park.exit', value: 'outside' },
  ]
  await edited(page, () =>
    page.evaluate(async (wanted) => {
      const { standing } = window.strandline.session.now
      const id = new URL(location.href).searchParams.get('project')
      const body = JSON.stringify({ revision: standing.revision, what: 'the field', changes: wanted })
      const reply = await fetch(`/api/v1/projects/${id}/edits`, { method: 'POST', headers: { 'Content-Type': 'application/json' }, body })
      if (!reply.ok) throw new Error(await reply.text())
    }, changes),
  )
  await page.waitForTimeout(200)
  const drive = await page.evaluate(() => window.strandline.session.now.drive)
  assert.equal(drive.connections[0].from, -1)
  assert.equal(drive.connections.at(-1).to, -1)
  assert.ok(drive.figures.in_driven > 0 && drive.figures.out_driven > 0)
  assert.notEqual(await pixels(), before)
  await picture('field')
  await page.keyboard.press('h')
  const p = await at(page, 7, 7)
  await page.mouse.move(p.x, p.y)
  await page.keyboard.press('Escape')
  assert.deepEqual(page.faults, [])
})
