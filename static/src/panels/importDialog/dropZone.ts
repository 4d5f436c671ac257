/** Takes files that you drop anywhere on the page. */

import "./dropZone.css";
import { html, render } from "lit-html";
import { el } from "../../ui/dom";
import { droppedFiles, type LocalFile } from "./localFiles";

const picture = html`<div class="drop-frame">
  <svg
    viewBox="0 0 64 64"
    width="96"
    height="96"
    fill="none"
    stroke="currentColor"
    stroke-width="2"
    stroke-linecap="round"
    stroke-linejoin="round"
  >
    <path class="drop-ground" d="M10 60h44" />
    <circle class="drop-head" cx="32" cy="18" r="6" stroke="none" />
    <path d="M32 26v18M32 32l-11 7M32 32l11 7M32 44l-8 15M32 44l8 15" />
  </svg>
  <strong>Drop your character</strong>
  <span>
    a .glb, .vrm, .md2, .x or .chunk, or a .gltf or .yaml with its files (or a .zip of them); a motion for
    this one: .bvh, .trc; or a machine that you exported: .zip
  </span>
</div>`;

const carriesFiles = (drag: DragEvent): boolean => drag.dataTransfer?.types.includes("Files") ?? false;

/** Calls `taken` with the dropped files, and with the files of dropped folders. */
export function dropZone(taken: (files: LocalFile[]) => void): void {
  const overlay = el("div", { class: "drop", "aria-hidden": "true" });
  render(picture, overlay);
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
