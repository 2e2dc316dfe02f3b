import { render } from 'preact'
import { useEffect, useRef, useState } from 'preact/hooks'
import { listenTo } from './canvas/gestures'
import { Stage } from './canvas/stage'
import { HintLine, ToolOptions, ToolRail } from './panels/Tools'
import { Panel } from './panels/Panel'
import { Playback } from './panels/Playback'
import { SavedCard } from './panels/ExportList'
import { TopBar } from './panels/TopBar'
import { begin, notify, openFile, session } from './session'
import { Toolbox } from './tools/tools'
import { view } from './view'
import './style/page.css'
import './style/desk.css'
import './style/panel.css'
import './style/playback.css'

function App() {
  const host = useRef<HTMLDivElement>(null)
  const stage = useRef<Stage | null>(null)
  const toolbox = useRef<Toolbox | null>(null)
  const [dropping, setDropping] = useState(false)
  useEffect(() => {
    stage.current = new Stage(host.current!)
    toolbox.current = new Toolbox(stage.current)
    listenTo(stage.current, toolbox.current)
    // For tests and benches: the page's own parts, nothing more.
    Object.assign(window, { strandline: { stage: stage.current, session, view } })
    begin().catch((error: Error) => notify(error.message))
  }, [])
  const show = (x: number, y: number) => stage.current?.show({ x, y })
  return (
    <div
      class={dropping ? 'app dropping' : 'app'}
      onDragOver={(event) => {
        event.preventDefault()
        setDropping(true)
      }}
      onDragLeave={(event) => event.relatedTarget === null && setDropping(false)}
      onDrop={(event) => {
        event.preventDefault()
        setDropping(false)
        const file = event.dataTransfer?.files[0]
        if (file) void openFile(file)
      }}
    >
      <TopBar />
      <main class="desk">
        <ToolRail fit={() => stage.current?.fit()} />
        <div class="view">
          <div class="canvas" ref={host} tabIndex={0} role="application" aria-label="Canvas: the drawing and how it is driven" />
          <ToolOptions />
          <SavedCard />
          <HintLine take={(offer) => toolbox.current?.take(offer)} />
        </div>
        <Panel show={show} />
      </main>
      <Playback />
    </div>
  )
}

render(<App />, document.getElementById('app')!)
