// From an edit to the new plan on the screen: milliseconds, with the part until the server has answered (kept on disk).
// STRANDLINE_PROGRAM=... node bench/edits.mjs DRAWING.svg...
import { openEditor, settled, startBrowser, startServer, tempFolder } from '../tests/editor.mjs'

const browser = await startBrowser()
for (const file of process.argv.slice(2)) {
  const folder = tempFolder()
  const server = await startServer(folder.path, file)
  const page = await openEditor(browser, server.url)
  await settled(page)
  const times = await page.evaluate(async () => {
    const { session } = window.strandline
    const { id } = session.now.standing
    const lines = session.now.drawing.elements.filter((e) => e.kind === 'line')
    const list = []
    for (let i = 0; i < 9; i++) {
      await new Promise((resolve) => setTimeout(resolve, 1200))
      const { revision } = session.now.standing
      const element = lines[i % lines.length]
      const direction = element.closed ? ['ccw', 'cw'][i % 2] : ['forward', 'backward'][i % 2]
      const shown = new Promise((resolve) => {
        const stop = session.listen((now) => {
          if (now.planned <= revision) return
          stop()
          requestAnimationFrame(() => setTimeout(resolve, 0))
        })
      })
      const from = performance.now()
      const body = JSON.stringify({ revision, what: 'turn', changes: [{ edit: { edit: 'direction', element: element.id, direction } }] })
      await fetch(`/api/v1/projects/${id}/edits`, { method: 'POST', headers: { 'Content-Type': 'application/json' }, body })
      const answered = performance.now() - from
      await shown
      list.push([performance.now() - from, answered])
    }
    const median = (k) => Math.round(list.map((t) => t[k]).sort((a, b) => a - b)[list.length >> 1])
    return { elements: session.now.drawing.elements.length, answered: median(1), shown: median(0) }
  })
  console.log(JSON.stringify({ drawing: file.split('/').pop(), ...times }))
  await page.context().close()
  await server.kill()
  folder.remove()
}
await browser.close()
