// What a page makes of the parts that it is sent: the same as all of them at once.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { join } from 'node:path'
import { openEditor, root, settled, startBrowser, startServer, tempFolder } from './editor.mjs'

let browser, server, folder, page
before(async () => {
  browser = await startBrowser()
  folder = tempFolder()
  server = await startServer(folder.path, join(root, 'web/tests/drawing.svg'))
  page = await openEditor(browser, server.url)
  await settled(page)
})
after(async () => {
  assert.deepEqual(page.faults, [])
  await browser.close()
  await server.kill()
  folder.remove()
})

test('samples put together of those that were there are those of a page that is opened anew', async () => {
  const line = await page.evaluate(() => window.strandline.session.now.drawing.elements.find((e) => e.kind === 'line' && !e.closed).id)
  const columns = (of) =>
    of.evaluate(() => {
      const { samples: s, drive } = window.strandline.session.now
      const list = (column) => [...column]
      return { tag: s.tag, kept: s.kept !== null, runs: drive.runs, t: list(s.t), rest: [s.x, s.y, s.heading, s.rakeX, s.rakeY, s.mask, s.stroke, s.motion].map(list) }
    })
  for (const direction of ['backward', 'forward']) {
    const { revision } = await page.evaluate(async (edit) => {
      const { id, revision } = window.strandline.session.now.standing
      const body = JSON.stringify({ revision, what: 'turn', changes: [{ edit }] })
      return (await fetch(`/api/v1/projects/${id}/edits`, { method: 'POST', headers: { 'Content-Type': 'application/json' }, body })).json()
    }, { edit: 'direction', element: line, direction })
    await settled(page, revision)
    const spliced = await columns(page)
    const other = await openEditor(browser, server.url)
    await settled(other, revision)
    const whole = await columns(other)
    await other.context().close()
    assert.equal(whole.kept, false)
    assert.ok(spliced.kept)
    assert.equal(spliced.tag, whole.tag)
    assert.deepEqual(spliced.rest, whole.rest)
    assert.deepEqual(spliced.runs, whole.runs)
    assert.equal(spliced.t.length, whole.t.length)
    spliced.t.forEach((t, i) => assert.ok(Math.abs(t - whole.t[i]) < 1e-4, `${i}`))
  }
})
