/**
 * The dialog of the twelve rules: a pasted file is solved by the server, its skeleton drawn (known bones
 * solid, deduced bones coloured, unknown bones dashed), and each value listed with the rule that found it.
 */

import "./deduce.css";
import { signal } from "@preact/signals-core";
import { html, svg, type TemplateResult } from "lit-html";
import { deduce } from "../../net/api";
import type { DeducedBone } from "../../net/protocol";
import { reasonOf } from "../../net/reason";
import { closeButton } from "../../ui/closeButton";
import { el } from "../../ui/dom";
import { draw } from "../../ui/draw";
import type { App } from "../../view/app";
import { type Segment, segments } from "./skeletonDrawing";

const EXAMPLE = `bones:
  upper: {length: 5, direction: [0, -1, 0]}
  fore: {parent: upper, length: 5, direction: [0, -1, 0]}
  hand: {parent: fore, length: 2, direction: [0, -1, 0]}
known:
  upper: {SP: [0, 0, 0]}
  fore: {EP: [2, -7, 0], bend: [-1, 0, 0]}
`;
const SIZE = 360;

const line = ({ name, from, to, kind }: Segment) =>
  svg`<g class=${kind}>
    <line x1=${from[0]} y1=${from[1]} x2=${to[0]} y2=${to[1]}><title .textContent=${name}></title></line>
    <circle cx=${to[0]} cy=${to[1]} r="3.5" />
  </g>`;

const row = (kind: Segment["kind"], ...cells: string[]): TemplateResult =>
  html`<tr class=${kind}>
    ${cells.map((cell) => html`<td .textContent=${cell}></td>`)}
  </tr>`;

function rows({ name, values, unknown }: DeducedBone): TemplateResult[] {
  const found = Object.entries(values).map(([quantity, { value, source }]) => {
    const kind = /^(rule|expr)/.test(source) ? "deduced" : "known";
    return row(kind, name, quantity, value.map((number) => Number(number.toFixed(4))).join("  "), source);
  });
  return [...found, ...unknown.map((quantity) => row("unknown", name, quantity, "?", "unknown"))];
}

/** The button `host` opens the dialog. */
export function deducePanel(host: HTMLElement, { commands }: App): void {
  const dialog = el("dialog", { class: "deduce", "aria-label": "inverse kinematics by rules" });
  const turn = signal(0);
  const problem = signal("");
  const bones = signal<readonly DeducedBone[]>([]);

  async function solve(): Promise<void> {
    try {
      bones.value = (await deduce(dialog.querySelector("textarea")!.value)).bones;
      problem.value = "";
    } catch (error) {
      problem.value = reasonOf(error);
    }
  }

  function open(): void {
    dialog.showModal();
    void solve();
  }

  const rotate = ({ target }: Event): void => void (turn.value = (target as HTMLInputElement).valueAsNumber);
  document.body.append(dialog);
  dialog.addEventListener("keydown", (press) => press.stopPropagation());
  draw(
    dialog,
    () =>
      html`${closeButton}
        <h2>Twelve rules: what follows from what is known</h2>
        <div class="deduce-columns">
          <div>
            <textarea aria-label="bones and known values" spellcheck="false" .value=${EXAMPLE}></textarea>
            <button type="button" class="primary" @click=${solve}>solve</button>
            <p class="problem" role="alert" .textContent=${problem.value}></p>
          </div>
          <div>
            <svg viewBox=${`0 0 ${SIZE} ${SIZE}`} role="img" aria-label="skeleton">
              ${segments(bones.value, turn.value, SIZE).map(line)}
            </svg>
            <input type="range" min="-180" max="180" aria-label="turn" @input=${rotate} />
          </div>
        </div>
        <table aria-label="values">
          <tbody>
            ${bones.value.flatMap(rows)}
          </tbody>
        </table>`,
  );
  host.addEventListener("click", open);
  commands.add({ keys: [], words: "IK rules: deduce bones", act: open });
}
