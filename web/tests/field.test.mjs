// The field tool: keep-outs, the border, where the robot is parked and where the drive ends.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { join } from 'node:path'
import { at, click, drag, edited, onePage, pictures, standing, view } from './editor.mjs'

let page
onePage((opened) => (page = opened))

const settingsNow = async () => (await standing(page)).settings
const corners = (text) => text.trim().split(/\s+/).map((pair) => pair.split(',').map(Number))
const fieldTool = async (what) => {
  await page.keyboard.press('b')
  assert.equal((await view(page)).tool, 'field')
  await page.selectOption('.options select >> nth=0', what)
}

test('field draws keep-outs as boxes and corner by corner, and moves, adds and takes out corners', async () => {
  await fieldTool('keep-out')
  assert.match((await view(page)).hint, /Drag a box/)
  await edited(page, () => drag(page, [[11, 4], [11.5, 4.5], [12, 5]]))
  assert.deepEqual(corners((await settingsNow())['field.keep_out']).map((p) => p.map((v) => +v.toFixed(1))), [[11, 4], [12, 4], [12, 5], [11, 5]])
  assert.equal((await page.evaluate(() => window.strandline.session.now.drawing.keep_out)).length, 1)
  // A second one, corner by corner; the first corner closes it.
  for (const [x, y] of [[10, 7], [12, 7], [12, 8]]) await click(page, x, y)
  assert.match((await view(page)).hint, /closes it/)
  await edited(page, () => click(page, 10, 7))
  let outlines = (await settingsNow())['field.keep_out'].split(';')
  assert.equal(outlines.length, 2)
  assert.equal(corners(outlines[1]).length, 3)
  // A corner is dragged, an edge gets one, the whole is moved.
  await edited(page, () => drag(page, [[12, 8], [12, 8.2], [11.6, 8.5]]))
  outlines = (await settingsNow())['field.keep_out'].split(';')
  assert.ok(Math.hypot(corners(outlines[1])[2][0] - 11.6, corners(outlines[1])[2][1] - 8.5) < 0.05)
  await edited(page, () => drag(page, [[11.5, 5], [11.5, 5.4], [11.5, 5.6]]))
  outlines = (await settingsNow())['field.keep_out'].split(';')
  assert.equal(corners(outlines[0]).length, 5)
  await edited(page, () => drag(page, [[11.3, 4.3], [11, 4.3], [10.8, 4.3]]))
  outlines = (await settingsNow())['field.keep_out'].split(';')
  assert.ok(Math.abs(corners(outlines[0])[0][0] - 10.5) < 0.05, outlines[0])
  if (pictures) await page.screenshot({ path: join(pictures, 'editor-fences.png') })
  // Delete takes the chosen corner out; a keep-out of two corners is none.
  await click(page, 10, 7)
  assert.deepEqual((await view(page)).field.corner, { fence: 2, corner: 0 })
  await edited(page, () => page.keyboard.press('Delete'))
  assert.equal((await settingsNow())['field.keep_out'].split(';').length, 1)
  await edited(page, () => page.keyboard.press('Control+z'))
  assert.equal((await settingsNow())['field.keep_out'].split(';').length, 2)
  await edited(page, () => page.click('.options >> text=None'))
  assert.equal((await settingsNow())['field.keep_out'], '')
})

test('Escape drops corners that were put, and nothing is changed', async () => {
  await fieldTool('keep-out')
  for (const [x, y] of [[10, 8], [11, 8], [11, 9]]) await click(page, x, y)
  await page.keyboard.press('Escape')
  await page.keyboard.press('b')
  await page.keyboard.press('Enter')
  assert.equal((await settingsNow())['field.keep_out'], '')
  assert.equal((await standing(page)).undo.count, 0)
})

test('field changes the border that holds, and puts it back', async () => {
  const before = await page.evaluate(() => window.strandline.session.now.drawing.border)
  assert.equal(before.length, 8)
  await fieldTool('border')
  await page.evaluate(() => {
    const { stage, session } = window.strandline
    const { border } = session.now.drawing
    stage.camera = { scale: 30, x: 300 - 30 * border[0], y: 400 + 30 * border[1] }
    stage.redraw()
  })
  await edited(page, () => drag(page, [[before[0], before[1]], [before[0] + 0.5, before[1] + 0.2], [before[0] + 1, before[1] + 0.5]]))
  const moved = corners((await settingsNow())['field.border'])
  assert.ok(moved.some(([x, y]) => Math.hypot(x - before[0] - 1, y - before[1] - 0.5) < 0.05), JSON.stringify(moved))
  await edited(page, () => page.click('.options >> text=By default'))
  assert.deepEqual(await page.evaluate(() => window.strandline.session.now.drawing.border), before)
  await page.keyboard.press('0')
})

test('field parks the robot and sends it to an exit, each pressed and dragged to where it looks', async () => {
  await fieldTool('park')
  await edited(page, () => drag(page, [[1, 1], [1, 1.5], [1, 2]]))
  let now = await settingsNow()
  assert.deepEqual([now['park.parked'], Math.round(parseFloat(now['park.heading']) * 100)], ['on', 157])
  const first = await page.evaluate(() => {
    const { samples: s } = window.strandline.session.now
    return [s.x[0], s.y[0], s.heading[0]]
  })
  assert.ok(Math.hypot(first[0] - 1, first[1] - 1, first[2] - Math.PI / 2) < 0.05, `begins at ${first}`)
  await page.selectOption('.options select >> nth=0', 'exit')
  await edited(page, () => drag(page, [[13, 1], [12.5, 1], [12, 1]]))
  now = await settingsNow()
  assert.equal(now['park.exit'], 'pose')
  // Moved by its point.
  await edited(page, () => drag(page, [[13, 1], [13, 1.5], [13, 2]]))
  const last = await page.evaluate(() => {
    const { samples: s } = window.strandline.session.now
    return [s.x[s.count - 1], s.y[s.count - 1]]
  })
  assert.ok(Math.hypot(last[0] - 13, last[1] - 2) < 0.05, `ends at ${last}`)
  if (pictures) await page.screenshot({ path: join(pictures, 'editor-park.png') })
  await edited(page, () => page.selectOption('.options select >> nth=1', 'outside'))
  assert.equal((await settingsNow())['park.exit'], 'outside')
  await page.selectOption('.options select >> nth=0', 'park')
  await edited(page, () => page.click('.options >> text=Nowhere of its own'))
  assert.equal((await settingsNow())['park.parked'], 'off')
})

test('a finger draws a keep-out', async () => {
  await fieldTool('keep-out')
  const [a, b] = [await at(page, 10, 8), await at(page, 11, 9)]
  await edited(page, () =>
    page.evaluate(
      ([x0, y0, x1, y1]) => {
        const { host } = window.strandline.stage
        const send = (type, x, y) =>
          host.dispatchEvent(new PointerEvent(type, { pointerId: 21, pointerType: 'touch', clientX: x, clientY: y, bubbles: true, button: 0 }))
        send('pointerdown', x0, y0)
        for (let i = 1; i <= 5; i++) send('pointermove', x0 + ((x1 - x0) * i) / 5, y0 + ((y1 - y0) * i) / 5)
        send('pointerup', x1, y1)
      },
      [a.x, a.y, b.x, b.y],
    ),
  )
  assert.equal(corners((await settingsNow())['field.keep_out']).length, 4)
})

test('an element becomes a keep-out in its card', async () => {
  await click(page, 4.5, 7)
  await edited(page, () => page.getByRole('region', { name: 'Element' }).getByLabel('Field').selectOption('keep-out'))
  assert.equal((await page.evaluate(() => window.strandline.session.now.drawing.keep_out)).length, 1)
})
