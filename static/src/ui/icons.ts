/** Draws the page's icons on a square of 16 units. */

import { svg } from "./dom";

const PATHS = {
  play: "M5 3.2v9.6a.6.6 0 0 0 .9.5l7.4-4.8a.6.6 0 0 0 0-1L5.9 2.7a.6.6 0 0 0-.9.5Z",
  pause: "M4.5 3h2.2v10H4.5zM9.3 3h2.2v10H9.3z",
  forward: "M4 3.6v8.8a.5.5 0 0 0 .8.4l5.7-4.4a.5.5 0 0 0 0-.8L4.8 3.2a.5.5 0 0 0-.8.4ZM11.4 3h1.6v10h-1.6z",
  back: "M12 3.6v8.8a.5.5 0 0 1-.8.4L5.5 8.4a.5.5 0 0 1 0-.8l5.7-4.4a.5.5 0 0 1 .8.4ZM3 3h1.6v10H3z",
  lines: "M2 3.4h12v1.6H2zM2 7.2h12v1.6H2zM2 11h12v1.6H2z",
  frame:
    "M2 6V2h4v1.5H3.5V6zM10 2h4v4h-1.5V3.5H10zM12.5 10H14v4h-4v-1.5h2.5zM3.5 10v2.5H6V14H2v-4z" +
    "M8 5.6a2.4 2.4 0 1 1 0 4.8 2.4 2.4 0 0 1 0-4.8Z",
  turn: "M8 2.6a5.4 5.4 0 1 1-5.2 4h1.6A3.9 3.9 0 1 0 8 4.1v1.8L4.9 3.3 8 .8z",
  undo: "M6.2 2.8v2.5h3.3a4 4 0 0 1 0 8H5v-1.6h4.5a2.4 2.4 0 0 0 0-4.8H6.2v2.5L2 6.1z",
  redo: "M9.8 2.8v2.5H6.5a4 4 0 0 0 0 8H11v-1.6H6.5a2.4 2.4 0 0 1 0-4.8h3.3v2.5L14 6.1z",
} as const;

export type IconName = keyof typeof PATHS;

export function icon(name: IconName): SVGSVGElement {
  return svg(
    "svg",
    { viewBox: "0 0 16 16", width: 16, height: 16, "aria-hidden": true, class: "icon" },
    svg("path", { d: PATHS[name], fill: "currentColor" }),
  );
}
