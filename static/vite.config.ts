/// <reference types="vitest/config" />
import { defineConfig } from "vite";

const SERVER = "http://127.0.0.1:8000";

/** `base: "./"` lets the page be mounted anywhere; in development `npm run dev` passes /api on to a running `statwalk serve`. */
export default defineConfig({
  base: "./",
  build: {
    target: "es2022",
    chunkSizeWarningLimit: 900,
    sourcemap: false,
    rolldownOptions: { input: ["index.html", "curves.html"] },
  },
  server: {
    proxy: {
      // the server refuses pages of another origin, so that requests get its own
      "/api": {
        target: SERVER,
        ws: true,
        changeOrigin: true,
        rewriteWsOrigin: true,
        headers: { origin: SERVER },
      },
    },
  },
  test: {
    include: ["src/**/*.test.ts"],
    environment: "node",
    pool: "threads", // takes a quarter less of the processors than processes do
    css: true,
    // Tests take lit's development build, which says so.
    onConsoleLog: (log) => !log.includes("Lit is in dev mode"),
  },
});
