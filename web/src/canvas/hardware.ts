// Who draws: a graphics chip, or the processor.

/**
 * Whether there is no graphics chip to be used. A canvas then had better be in main memory (willReadFrequently): else each
 * drawing is recorded, sent to another process and drawn there, by the same processor.
 */
export function drawnByProcessor(): boolean {
  const gl = document.createElement('canvas').getContext('webgl')
  if (!gl) return true
  const named = gl.getExtension('WEBGL_debug_renderer_info')
  const name = named ? String(gl.getParameter(named.UNMASKED_RENDERER_WEBGL)) : ''
  gl.getExtension('WEBGL_lose_context')?.loseContext()
  return /swiftshader|llvmpipe|software/i.test(name)
}
