// Painters of what lies above the drive: marks of check, the robot, the ruler.
import type { Drive, Report } from '../api/client'
import type { Samples } from '../plan/samples'
import type { Camera } from './camera'
import { gridStep } from './paint'
import type { Ctx } from './paint'
import { palette } from './palette'

/** What has happened by then (null: by the end). Crosses where a law is broken, rings where finished ground is driven over, squares where sand stays bare. */
export function paintFaults(ctx: Ctx, report: Report | null, drive: Drive, camera: Camera, until: { time: number; sample: number } | null): void {
  const mark = (x: number, y: number) => ({ x: camera.x + x * camera.scale, y: camera.y - y * camera.scale })
  ctx.lineWidth = 1.7
  ctx.strokeStyle = palette.blemish
  for (const blemish of report?.blemishes ?? []) {
    if (until && blemish.t > until.time) continue
    const p = mark(blemish.x, blemish.y)
    ctx.beginPath()
    ctx.arc(p.x, p.y, 5.5, 0, 2 * Math.PI)
    ctx.stroke()
  }
  for (const spot of until ? [] : drive.bare) {
    const p = mark(spot.at[0], spot.at[1])
    ctx.strokeRect(p.x - 4.5, p.y - 4.5, 9, 9)
  }
  ctx.strokeStyle = palette.fault
  ctx.lineWidth = 2.5
  const cross = (x: number, y: number) => {
    const p = mark(x, y)
    ctx.beginPath()
    ctx.moveTo(p.x - 6, p.y - 6)
    ctx.lineTo(p.x + 6, p.y + 6)
    ctx.moveTo(p.x + 6, p.y - 6)
    ctx.lineTo(p.x - 6, p.y + 6)
    ctx.stroke()
  }
  for (const fault of report?.faults ?? []) if (!until || fault.sample <= until.sample) cross(fault.x, fault.y)
  for (const spot of until ? [] : drive.undrivable) cross(spot.at[0], spot.at[1])
}

/** The robot to scale: footprint, wheels, the bar and which of its pins are down. */
export function paintRobot(ctx: Ctx, s: Samples, drive: Drive, index: number, scale: number): void {
  if (s.count === 0) return
  const { front, back, half_width, wheels, rake_offset, rake_side, pins, pin_pitch } = drive.robot
  ctx.save()
  ctx.translate(s.x[index], s.y[index])
  ctx.rotate(s.heading[index])
  ctx.lineWidth = 1.5 / scale
  ctx.fillStyle = 'rgba(29, 75, 82, 0.16)'
  ctx.strokeStyle = palette.robot
  ctx.beginPath()
  ctx.roundRect(-back, -half_width, front + back, 2 * half_width, 0.12 * half_width)
  ctx.fill()
  ctx.stroke()
  ctx.fillStyle = 'rgba(29, 75, 82, 0.75)'
  for (const [x, y, width] of wheels) ctx.fillRect(x - 1.3 * width, y - width / 2, 2.6 * width, width)
  ctx.beginPath()
  ctx.moveTo(front - 0.12 * (front + back), 0.3 * half_width)
  ctx.lineTo(front - 0.02 * (front + back), 0)
  ctx.lineTo(front - 0.12 * (front + back), -0.3 * half_width)
  ctx.stroke()
  ctx.lineWidth = Math.max(0.02, 2 / scale)
  ctx.beginPath()
  ctx.moveTo(-rake_offset, rake_side - (pins * pin_pitch) / 2)
  ctx.lineTo(-rake_offset, rake_side + (pins * pin_pitch) / 2)
  ctx.stroke()
  const mask = s.mask[index]
  for (let i = 0; i < pins; i++) {
    ctx.beginPath()
    ctx.arc(-rake_offset, rake_side + (i - (pins - 1) / 2) * pin_pitch, Math.max(pin_pitch * 0.32, 1.5 / scale), 0, 2 * Math.PI)
    ctx.fillStyle = mask & (1 << i) ? palette.trip : '#f7f0e0'
    ctx.fill()
    ctx.lineWidth = 1 / scale
    ctx.stroke()
  }
  ctx.restore()
}

/** Lengths along the left and lower edge, in metres. */
export function paintRuler(ctx: Ctx, camera: Camera, width: number, height: number): void {
  const step = gridStep(camera.scale)
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9))
  const thick = 20
  ctx.fillStyle = 'rgba(251, 248, 241, 0.92)'
  ctx.fillRect(0, height - thick, width, thick)
  ctx.fillRect(0, 0, thick + 8, height - thick)
  ctx.fillStyle = '#5c5140'
  ctx.strokeStyle = '#a8997c'
  ctx.lineWidth = 1
  ctx.font = '11px system-ui, sans-serif'
  ctx.textAlign = 'center'
  ctx.textBaseline = 'middle'
  ctx.beginPath()
  for (let i = Math.ceil((thick + 20 - camera.x) / camera.scale / step); camera.x + i * step * camera.scale < width; i++) {
    const x = Math.round(camera.x + i * step * camera.scale) + 0.5
    ctx.moveTo(x, height - thick)
    ctx.lineTo(x, height - thick + 4)
    ctx.fillText((i * step).toFixed(digits), x, height - thick / 2 + 2)
  }
  for (let i = Math.ceil((camera.y - (height - thick - 10)) / camera.scale / step); camera.y - i * step * camera.scale > 0; i++) {
    const y = Math.round(camera.y - i * step * camera.scale) + 0.5
    ctx.moveTo(thick + 4, y)
    ctx.lineTo(thick + 8, y)
    ctx.fillText((i * step).toFixed(digits), (thick + 5) / 2, y)
  }
  ctx.stroke()
  ctx.fillText('m', (thick + 8) / 2, height - thick / 2)
}
