/// <reference types="vitest/config" />
import { defineConfig } from "vite";

/** `base: "./"` lets the page be mounted anywhere; in development `npm run dev` passes /api on to a running `statwalk serve`. */
export default defineConfig({
  base: "./",
  build: {
    target: "es2022",
    chunkSizeWarningLimit: 900,
    sourcemap: false,
    rolldownOptions: { input: ["index.html", "curves.html"] },
  },
  server: { proxy: { "/api": { target: "http://127.0.0.1:8000", ws: true, changeOrigin: true } } },
  test: { include: ["src/**/*.test.ts"], environment: "node" },
});
