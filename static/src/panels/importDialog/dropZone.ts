/** Takes files that you drop anywhere on the page. */

import "./dropZone.css";
import { el, svg } from "../../ui/dom";
import { droppedFiles, type LocalFile } from "./localFiles";

function picture(): SVGElement {
  const line = {
    fill: "none",
    stroke: "currentColor",
    "stroke-width": 2,
    "stroke-linecap": "round",
    "stroke-linejoin": "round",
  };
  const figure = svg("path", { ...line, d: "M32 26v18M32 32l-11 7M32 32l11 7M32 44l-8 15M32 44l8 15" });
  const ground = svg("path", { ...line, d: "M10 60h44", class: "drop-ground" });
  return svg(
    "svg",
    { viewBox: "0 0 64 64", width: 96, height: 96, "aria-hidden": "true" },
    ground,
    svg("circle", { cx: 32, cy: 18, r: 6, class: "drop-head" }),
    figure,
  );
}

const carriesFiles = (drag: DragEvent): boolean => drag.dataTransfer?.types.includes("Files") ?? false;

/** Calls `taken` with the dropped files, and with the files of dropped folders. */
export function dropZone(taken: (files: LocalFile[]) => void): void {
  const words = [
    el("strong", {}, "Drop your character"),
    el(
      "span",
      {},
      "a .glb, .vrm, .md2, .x or .chunk, or a .gltf or .yaml with its files (or a .zip of them); a motion for this one: .bvh, .trc; or a machine that you exported: .zip",
    ),
  ];
  const overlay = el(
    "div",
    { class: "drop", "aria-hidden": "true" },
    el("div", { class: "drop-frame" }, picture(), ...words),
  );
  document.body.append(overlay);
  const show = (on: boolean): void => void overlay.classList.toggle("on", on);
  window.addEventListener("dragover", (drag) => {
    if (!carriesFiles(drag)) return;
    drag.preventDefault();
    drag.dataTransfer!.dropEffect = "copy";
    show(true);
  });
  window.addEventListener("dragleave", (drag) => drag.relatedTarget === null && show(false));
  window.addEventListener("drop", (drop) => {
    show(false);
    if (!carriesFiles(drop)) return;
    drop.preventDefault();
    void droppedFiles(drop.dataTransfer!).then(taken);
  });
}
