import { useStore } from '../store'
import type { Tab } from '../view'
import { view } from '../view'
import { ChangesPanel } from './ChangesPanel'
import { ElementCard } from './ElementCard'
import { OrderPanel } from './OrderPanel'
import { PlanPanel } from './PlanPanel'
import { SettingsPanel } from './SettingsPanel'

const tabs: [Tab, string][] = [
  ['plan', 'Plan'],
  ['order', 'Order'],
  ['settings', 'Settings'],
  ['changes', 'Changes'],
]

export function Panel({ show }: { show: (x: number, y: number) => void }) {
  const { tab, panelOpen } = useStore(view, (v) => v)
  if (!panelOpen) return null
  return (
    <aside class="panel" aria-label="Panel">
      <div class="tabs" role="tablist">
        {tabs.map(([name, label]) => (
          <button role="tab" id={`tab-${name}`} aria-controls="tab-body" aria-selected={tab === name} onClick={() => view.set({ tab: name })}>
            {label}
          </button>
        ))}
      </div>
      <div class="body" role="tabpanel" id="tab-body" aria-labelledby={`tab-${tab}`} tabIndex={0}>
        <ElementCard show={show} />
        {tab === 'plan' && <PlanPanel show={show} />}
        {tab === 'order' && <OrderPanel show={show} />}
        {tab === 'settings' && <SettingsPanel />}
        {tab === 'changes' && <ChangesPanel />}
      </div>
    </aside>
  )
}
