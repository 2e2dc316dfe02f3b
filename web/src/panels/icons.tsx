// One line each, drawn on 24 x 24.
const lines: Record<string, string> = {
  select: 'M6 3l12 9-5.5 1L16 20l-2.6 1.2L10 14.4 6 18z',
  link: 'M5 18c0-8 14-4 14-12M5 18m-2.4 0a2.4 2.4 0 1 0 4.8 0a2.4 2.4 0 1 0-4.8 0M19 6m-2.4 0a2.4 2.4 0 1 0 4.8 0a2.4 2.4 0 1 0-4.8 0',
  shape: 'M3 18c5 0 4-11 9-11s4 8 9 8M12 7m-2.4 0a2.4 2.4 0 1 0 4.8 0a2.4 2.4 0 1 0-4.8 0M12 7h6',
  end: 'M6 21V4M6 5h12v8H6M6 9h12M10 5v8M14 5v8',
  start: 'M6 21V4M6 5h11l-2.5 4L17 13H6',
  entry: 'M20 12a8 8 0 1 1-3-6.2M12 12l7-8M19 4h-4.5M19 4v4.5',
  fill: 'M4 4h16v16H4zM4 9h16M4 14h16M20 9v5',
  cut: 'M4 20L20 4M4 8a3 3 0 1 0 3-3M20 16a3 3 0 1 1-3 3',
  field: 'M4 5l15-1 1 15-14 1zM4 5m-1.6 0a1.6 1.6 0 1 0 3.2 0a1.6 1.6 0 1 0-3.2 0M20 19m-1.6 0a1.6 1.6 0 1 0 3.2 0a1.6 1.6 0 1 0-3.2 0M10 9.5h4v4h-4z',
  draw: 'M4 20l1-4L16.5 4.5l3 3L8 19zM14 7l3 3',
  text: 'M5 6V4h14v2M12 4v16M9 20h6',
  erase: 'M8 20h11M5 15l9-10 6 5-8.5 9.5H8z',
  undo: 'M9 6L4 11l5 5M4 11h10a5 5 0 0 1 0 10h-3',
  redo: 'M15 6l5 5-5 5M20 11H10a5 5 0 0 0 0 10h3',
  fit: 'M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5',
  eye: 'M2 12s4-7 10-7 10 7 10 7-4 7-10 7-10-7-10-7zM12 12m-3 0a3 3 0 1 0 6 0a3 3 0 1 0-6 0',
  play: 'M7 4l13 8-13 8z',
  pause: 'M8 5v14M16 5v14',
  stop: 'M5 5h14v14H5z',
  panel: 'M4 5h16v14H4zM15 5v14',
  open: 'M3 19V5h6l2 2h10v12zM3 11h18',
  export: 'M12 3v12M7 10l5 5 5-5M4 20h16',
  bin: 'M5 7h14M9 7V4h6v3M7 7l1 13h8l1-13M10.5 11v5M13.5 11v5',
  close: 'M6 6l12 12M18 6L6 18',
  drag: 'M9 5v.01M15 5v.01M9 12v.01M15 12v.01M9 19v.01M15 19v.01',
}

export function Icon({ name }: { name: string }) {
  return (
    <svg class="icon" viewBox="0 0 24 24" aria-hidden="true">
      <path d={lines[name]} />
    </svg>
  )
}
