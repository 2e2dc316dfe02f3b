// Every tool, from the mouse to the new plan (the field tool: field.test.mjs).
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { join } from 'node:path'
import { at, click, drag, edited, elements, onePage, pictures, standing, view } from './editor.mjs'

let page
onePage((opened) => (page = opened))

const edits = async () => (await standing(page)).edits

test('select shows the element, Delete erases it, undo and redo bring it back and away', async () => {
  await click(page, 4.5, 7)
  assert.equal((await view(page)).selected, 'mast')
  await page.getByRole('region', { name: 'Element' }).getByText('mast').waitFor()
  await edited(page, () => page.keyboard.press('Delete'))
  assert.ok(!(await elements(page)).some((e) => e.id === 'mast'))
  await edited(page, () => page.keyboard.press('Control+z'))
  assert.ok((await elements(page)).some((e) => e.id === 'mast'))
  await edited(page, () => page.keyboard.press('Control+Shift+z'))
  assert.ok(!(await elements(page)).some((e) => e.id === 'mast'))
})

test('connect ties two nodes, and a new connection replaces the old', async () => {
  await page.keyboard.press('c')
  await click(page, 4.5, 4.5)
  await edited(page, () => click(page, 2, 2))
  const [link] = await edits()
  assert.deepEqual([link.edit, link.a[0], link.b[0]], ['link', 'mast', 'wave'])
  const order = await page.evaluate(() => {
    const { drive, drawing } = window.strandline.session.now
    return drive.strokes.map((s) => drawing.elements[s.element].id).filter((id) => id === 'mast' || id === 'wave')
  })
  assert.equal(order.length, 2)
  await page.keyboard.press('c')
  await click(page, 4.5, 4.5)
  await edited(page, () => click(page, 12.5, 2))
  assert.equal((await edits()).length, 1)
  assert.equal((await edits())[0].b[1], -1)
})

test('Escape lets a connection go that was begun', async () => {
  await page.keyboard.press('c')
  await click(page, 4.5, 4.5)
  assert.match((await view(page)).hint, /From mast/)
  await page.keyboard.press('Escape')
  assert.equal((await view(page)).tool, 'select')
  assert.deepEqual(await edits(), [])
})

/** Connections between elements as the page has them: names, and the robot's way. */
const trips = () =>
  page.evaluate(() => {
    const { drawing, drive, samples } = window.strandline.session.now
    const name = (stroke) => drawing.elements[drive.strokes[stroke].element].id
    return drive.connections
      .filter((c) => name(c.from) !== name(c.to))
      .map((c) => {
        let [first, last] = [drive.strokes[c.from].last, drive.strokes[c.to].first]
        while (samples.motion[first] !== 3) first++
        while (samples.motion[last - 1] !== 3) last--
        const way = []
        for (let i = first; i <= last; i++) way.push([samples.x[i], samples.y[i]])
        return { from: name(c.from), to: name(c.to), way }
      })
  })
const nearest = (way, [x, y]) => Math.min(...way.map((p) => Math.hypot(p[0] - x, p[1] - y)))

test('shape leads a connection through points that are put in, moved, turned and taken out', async () => {
  const longest = (await trips()).reduce((a, b) => (a.way.length > b.way.length ? a : b))
  const middle = longest.way[longest.way.length >> 1]
  const same = async () => (await trips()).find((t) => t.from === longest.from && t.to === longest.to)
  const pose = async () => (await edits()).find((e) => e.edit === 'through').poses[0]
  await page.keyboard.press('h')
  await click(page, ...middle)
  assert.deepEqual((await view(page)).shape, { from: longest.from, to: longest.to, pose: -1 })
  assert.deepEqual(await edits(), [], 'a click changes nothing')
  // Put in, and the curve is asked for while it is dragged.
  const asked = page.waitForResponse((r) => r.url().endsWith('/connection') && r.status() === 200)
  await edited(page, () => drag(page, [middle, [middle[0] + 0.4, middle[1] + 0.4], [middle[0] + 1, middle[1] + 1]]))
  await asked
  const [x, y] = await pose()
  assert.ok(Math.hypot(x - middle[0] - 1, y - middle[1] - 1) < 0.05)
  assert.ok(nearest((await same()).way, [x, y]) < 0.05, 'it is driven through there')
  // Moved.
  await edited(page, () => drag(page, [[x, y], [x - 0.3, y + 0.6]]))
  const moved = await pose()
  assert.ok(Math.hypot(moved[0] - x + 0.3, moved[1] - y - 0.6) < 0.05)
  assert.ok(nearest((await same()).way, moved) < 0.05)
  // Turned by its arrow.
  const grip = await page.evaluate(() => 38 / window.strandline.stage.camera.scale)
  const tip = (by) => [moved[0] + grip * Math.cos(moved[2] + by), moved[1] + grip * Math.sin(moved[2] + by)]
  await edited(page, () => drag(page, [tip(0), tip(0.3), tip(0.6)]))
  const turned = await pose()
  assert.ok(Math.abs(turned[2] - moved[2] - 0.6) < 0.1, `turned by ${turned[2] - moved[2]}`)
  if (pictures) await page.screenshot({ path: join(pictures, 'editor-shape.png') })
  await edited(page, () => page.keyboard.press('Delete'))
  assert.equal((await edits()).filter((e) => e.edit === 'through').length, 0)
})

test('shape leads a drive within an area through a point', async () => {
  await page.keyboard.press('f')
  await page.selectOption('.options select >> nth=0', 'zigzag')
  await edited(page, () => click(page, 6, 6.5))
  const hops = () =>
    page.evaluate(() => {
      const { drive, samples } = window.strandline.session.now
      return drive.connections
        .filter((c) => c.hop)
        .map((c) => {
          let [first, last] = [drive.strokes[c.from].last, drive.strokes[c.to].first]
          while (samples.motion[first] !== 3 && first < last) first++
          while (samples.motion[last - 1] !== 3 && first < last) last--
          const way = []
          for (let i = first; i <= last; i++) way.push([samples.x[i], samples.y[i]])
          return { hop: c.hop, way }
        })
    })
  const longest = (await hops()).reduce((a, b) => (a.way.length > b.way.length ? a : b))
  const middle = longest.way[longest.way.length >> 1]
  await page.keyboard.press('h')
  await edited(page, () => drag(page, [middle, [middle[0] + 0.3, middle[1] + 0.3], [middle[0] + 0.6, middle[1] + 0.5]]))
  const edit = (await edits()).find((e) => e.edit === 'through')
  assert.deepEqual([edit.from, edit.to], ['sail', 'sail'])
  assert.ok(edit.hop.every((v, i) => Math.abs(v - longest.hop[i]) < 1e-3))
  const led = (await hops()).find((h) => h.hop.every((v, i) => Math.abs(v - longest.hop[i]) < 1e-3))
  assert.ok(nearest(led.way, edit.poses[0]) < 0.05, 'it is driven through there')
  assert.deepEqual(await page.evaluate(() => window.strandline.session.now.drive.idle), [])
  if (pictures) await page.screenshot({ path: join(pictures, 'editor-hop.png') })
  await edited(page, () => page.keyboard.press('Delete'))
  assert.equal((await edits()).filter((e) => e.edit === 'through').length, 0)
})

test('points too near to each other for the robot are said to be', async () => {
  const longest = (await trips()).reduce((a, b) => (a.way.length > b.way.length ? a : b))
  const middle = longest.way[longest.way.length >> 1]
  await page.keyboard.press('h')
  await edited(page, () => drag(page, [middle, [middle[0] + 0.5, middle[1] + 0.5]]))
  const [x, y, heading] = (await edits()).find((e) => e.edit === 'through').poses[0]
  // Another point, from further along to right beside the first.
  const { way } = (await trips()).find((t) => t.from === longest.from && t.to === longest.to)
  const here = way.findIndex((p) => Math.hypot(p[0] - x, p[1] - y) < 0.05)
  const further = way.find((p, i) => i > here && Math.hypot(p[0] - x, p[1] - y) > 0.5)
  const beside = await at(page, x - 0.25 * Math.sin(heading), y + 0.25 * Math.cos(heading))
  const p = await at(page, ...further)
  await page.mouse.move(p.x, p.y)
  await page.mouse.down()
  await page.mouse.move(beside.x, beside.y, { steps: 8 })
  await page.waitForFunction(() => /go round in a loop/.test(window.strandline.view.now.hint))
  if (pictures) await page.screenshot({ path: join(pictures, 'editor-tight.png') })
  await page.keyboard.press('Escape')
  await page.mouse.up()
  assert.equal((await edits()).find((e) => e.edit === 'through').poses.length, 1, 'Escape leaves it as it was')
})

test('start is where the drive begins', async () => {
  await page.keyboard.press('s')
  const now = await edited(page, () => click(page, 12.5, 2))
  assert.equal(now.settings['tour.has_start'], 'on')
  const first = await page.evaluate(() => {
    const { samples } = window.strandline.session.now
    return Math.hypot(samples.rakeX[0] - 12.5, samples.rakeY[0] - 2)
  })
  assert.ok(first < 3, `begins ${first} m away`)
})

test('end is where the drive ends', async () => {
  await page.keyboard.press('l')
  const now = await edited(page, () => click(page, 2, 2))
  assert.equal(now.settings['tour.has_end'], 'on')
  const last = await page.evaluate(() => {
    const { samples } = window.strandline.session.now
    return Math.hypot(samples.rakeX[samples.count - 1] - 2, samples.rakeY[samples.count - 1] - 2)
  })
  assert.ok(last < 3, `ends ${last} m away`)
})

test('entry is where a closed line is entered', async () => {
  await page.keyboard.press('n')
  const nodes = (await elements(page)).find((e) => e.id === 'sun').nodes
  await edited(page, () => click(page, nodes[4], nodes[5]))
  assert.deepEqual(await edits(), [{ edit: 'entry', at: ['sun', 2] }])
  const entered = await page.evaluate(() => {
    const { drive, drawing } = window.strandline.session.now
    const sun = drawing.elements.findIndex((e) => e.id === 'sun')
    return drive.strokes.find((s) => s.element === sun).node
  })
  assert.equal(entered, 2)
})

test('fill sets the style by a click and the direction by a drag', async () => {
  await page.keyboard.press('f')
  await page.selectOption('.options select >> nth=0', 'spiral')
  await edited(page, () => click(page, 6, 6.5))
  assert.equal((await elements(page)).find((e) => e.id === 'sail').hints['fill-style'], 'spiral')
  await edited(page, () => drag(page, [[5.6, 5.5], [6.6, 6.5]]))
  const { hints } = (await elements(page)).find((e) => e.id === 'sail')
  assert.deepEqual([hints['fill-style'], hints['fill-direction'], hints['fill-best-direction']], ['zigzag', '45deg', 'off'])
})

test('fill of a segment, and cut', async () => {
  await page.keyboard.press('x')
  await edited(page, () => drag(page, [[4.9, 6.5], [10, 6.5]]))
  assert.match((await elements(page)).find((e) => e.id === 'sail').hints['fill-cuts'], /^[\d.]+,[\d.]+ [\d.]+,[\d.]+$/)
  await page.keyboard.press('f')
  await page.selectOption('.options select >> nth=1', 'segment')
  await edited(page, () => drag(page, [[5.6, 5.3], [6.6, 5.3]]))
  await page.selectOption('.options select >> nth=1', 'area')
  assert.match((await elements(page)).find((e) => e.id === 'sail').hints['fill-segments'], /direction=0deg$/)
})

test('draw makes a smooth line, closed where its ends meet', async () => {
  await page.keyboard.press('d')
  await edited(page, () => drag(page, [[8, 11], [9, 11.5], [10, 11], [11, 11.5], [12, 11]]))
  const ring = Array.from({ length: 13 }, (_, i) => [3 + Math.cos((i * Math.PI) / 6), 11.5 + Math.sin((i * Math.PI) / 6)])
  await edited(page, () => drag(page, ring))
  const drawn = (await elements(page)).filter((e) => e.id.startsWith('pen'))
  assert.deepEqual(drawn.map((e) => e.closed), [false, true])
  assert.ok(drawn[0].nodes.length < 20, 'smoothed into few curves')
})

test('text is written where the canvas is clicked', async () => {
  await page.keyboard.press('t')
  await page.fill('.options textarea', 'Sea')
  await edited(page, () => click(page, 6, 10))
  const letters = (await elements(page)).filter((e) => e.id.startsWith('text1'))
  assert.ok(letters.length >= 3)
  assert.ok(letters.every((e) => e.points.every((v, i) => (i % 2 === 0 ? v > 5.9 : v > 9.4))))
})

test('erase takes out what is dragged across', async () => {
  await page.keyboard.press('e')
  await edited(page, () => drag(page, [[4, 8], [4.5, 8], [4.9, 8]]))
  assert.deepEqual((await edits()).map((e) => [e.element, e.value]), [['mast', 'off']])
})

test('order is dragged in the list, kept, and left to the planner again', async () => {
  await page.click('role=tab[name="Order"]')
  const names = () => page.$$eval('.order .name', (rows) => rows.map((row) => row.textContent.replace(/^\d+/, '').replace(/(area|[\d.]+ m)$/, '')))
  const before = await names()
  const from = await page.locator('.order .handle').nth(4).boundingBox()
  const to = await page.locator('.order .handle').nth(0).boundingBox()
  await edited(page, async () => {
    await page.mouse.move(from.x + 10, from.y + 10)
    await page.mouse.down()
    await page.mouse.move(to.x + 12, to.y + 8, { steps: 6 })
    await page.mouse.up()
  })
  assert.deepEqual(await names(), [before[4], ...before.slice(0, 4)])
  await page.locator('.order .name').nth(0).focus()
  await edited(page, () => page.keyboard.press('Alt+ArrowDown'))
  assert.deepEqual((await names()).slice(0, 2), [before[0], before[4]])
  await edited(page, () => page.click('text=Leave the order to the planner'))
  assert.deepEqual(await edits(), [])
})

test('a finger draws, two fingers move the view and draw nothing', async () => {
  await page.keyboard.press('d')
  const camera = () => page.evaluate(() => ({ ...window.strandline.stage.camera }))
  const before = await camera()
  const p = await at(page, 7, 7)
  await page.evaluate(
    ([x, y]) => {
      const { host } = window.strandline.stage
      const send = (type, id, dx, dy) =>
        host.dispatchEvent(new PointerEvent(type, { pointerId: id, pointerType: 'touch', clientX: x + dx, clientY: y + dy, bubbles: true, button: 0 }))
      send('pointerdown', 11, 0, 0)
      send('pointerdown', 12, 100, 0)
      for (let i = 0; i <= 10; i++) send('pointermove', 12, 100 + 10 * i, 0)
      send('pointerup', 12, 200, 0)
      send('pointerup', 11, 0, 0)
    },
    [p.x, p.y],
  )
  const now = await camera()
  assert.ok(Math.abs(now.scale / before.scale - 2) < 0.05, `zoomed by ${now.scale / before.scale}`)
  assert.deepEqual(await edits(), [])
  await page.keyboard.press('0')
})
