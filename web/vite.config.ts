import { defineConfig } from 'vite'

// The server serves dist; in development `npx vite` asks it for the API.
export default defineConfig({
  build: { target: 'es2022', sourcemap: false },
  server: { proxy: { '/api': 'http://localhost:8014' } },
})
