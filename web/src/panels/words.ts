// Figures as people read them.
export function duration(seconds: number): string {
  const whole = Math.round(seconds)
  if (whole >= 3600) return `${Math.floor(whole / 3600)} h ${String(Math.floor((whole % 3600) / 60)).padStart(2, '0')} min`
  return `${Math.floor(whole / 60)} min ${String(whole % 60).padStart(2, '0')} s`
}
export const metres = (value: number) => `${value.toFixed(value < 10 ? 2 : 1)} m`
/** Small areas in square centimetres. */
export const area = (value: number) => (value < 0.1 ? `${(1e4 * value).toFixed(0)} cm²` : `${value.toFixed(2)} m²`)
export const percent = (share: number) => `${(100 * share).toFixed(1)} %`
/** Of any size: "0.0001", "100,000", "10^15". */
export function written(value: number): string {
  const size = Math.abs(value)
  if (size > 0 && (size >= 1e10 || size < 1e-4)) {
    const [digits, power] = value.toExponential().split('e')
    return `${digits === '1' ? '' : `${digits} × `}10^${+power}`
  }
  return value.toLocaleString('en-GB', { maximumFractionDigits: 4 })
}
/** "fill.min_area" -> "min area". */
export const spoken = (key: string) => key.slice(key.indexOf('.') + 1).replaceAll('_', ' ')
export const counted = (n: number, word: string) => `${n} ${word}${n === 1 ? '' : 's'}`
