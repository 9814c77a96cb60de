import { defineConfig } from 'vitest/config';

// Addresses of files are relative, so that the page works below any path.
export default defineConfig({
  base: './',
  build: {
    target: 'es2022',
    chunkSizeWarningLimit: 900,
    assetsInlineLimit: 0,
  },
  server: { host: '127.0.0.1' },
  test: { include: ['test/unit/**/*.test.ts'] },
});
