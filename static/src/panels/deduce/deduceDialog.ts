/**
 * The dialog of the twelve rules: a pasted file is solved by the server, its skeleton drawn (known bones
 * solid, deduced bones coloured, unknown bones dashed), and each value listed with the rule that found it.
 */

import "./deduce.css";
import { deduce } from "../../net/api";
import type { DeducedBone } from "../../net/protocol";
import { reasonOf } from "../../net/reason";
import { el, say, svg } from "../../ui/dom";
import type { App } from "../../view/app";
import { segments } from "./skeletonDrawing";

const EXAMPLE = `bones:
  upper: {length: 5, direction: [0, -1, 0]}
  fore: {parent: upper, length: 5, direction: [0, -1, 0]}
  hand: {parent: fore, length: 2, direction: [0, -1, 0]}
known:
  upper: {SP: [0, 0, 0]}
  fore: {EP: [2, -7, 0], bend: [-1, 0, 0]}
`;
const SIZE = 360;

class DeduceDialog {
  private readonly text = el(
    "textarea",
    { "aria-label": "bones and known values", spellcheck: "false" },
    EXAMPLE,
  );
  private readonly problem = el("p", { class: "problem", role: "alert" });
  private readonly drawing = svg("svg", {
    viewBox: `0 0 ${SIZE} ${SIZE}`,
    role: "img",
    "aria-label": "skeleton",
  });
  private readonly turn = el("input", { type: "range", min: -180, max: 180, value: 0, "aria-label": "turn" });
  private readonly list = el("tbody");
  private readonly dialog: HTMLDialogElement;
  private bones: readonly DeducedBone[] = [];

  constructor() {
    const solve = el("button", { type: "button", class: "primary" }, "solve");
    const close = el("button", { type: "button", class: "plain close", "aria-label": "esc: close" }, "esc");
    const left = el("div", {}, this.text, solve, this.problem);
    const right = el("div", {}, this.drawing, this.turn);
    const values = el("table", { "aria-label": "values" }, this.list);
    this.dialog = el(
      "dialog",
      { class: "deduce", "aria-label": "inverse kinematics by rules" },
      close,
      el("h2", {}, "Twelve rules: what follows from what is known"),
      el("div", { class: "deduce-columns" }, left, right),
      values,
    );
    document.body.append(this.dialog);
    solve.addEventListener("click", () => void this.solve());
    close.addEventListener("click", () => this.dialog.close());
    this.turn.addEventListener("input", () => this.draw());
    this.dialog.addEventListener("keydown", (press) => press.stopPropagation());
  }

  open(): void {
    this.dialog.showModal();
    void this.solve();
  }

  private async solve(): Promise<void> {
    try {
      this.bones = (await deduce(this.text.value)).bones;
      say(this.problem, "");
    } catch (error) {
      say(this.problem, reasonOf(error));
      return;
    }
    this.draw();
    this.list.replaceChildren(...this.bones.flatMap((bone) => this.rows(bone)));
  }

  private draw(): void {
    const lines = segments(this.bones, this.turn.valueAsNumber, SIZE).map(({ name, from, to, kind }) =>
      svg(
        "g",
        { class: kind },
        svg("line", { x1: from[0], y1: from[1], x2: to[0], y2: to[1] }, svg("title", {}, name)),
        svg("circle", { cx: to[0], cy: to[1], r: 3.5 }),
      ),
    );
    this.drawing.replaceChildren(...lines);
  }

  private rows(bone: DeducedBone): HTMLElement[] {
    const found = Object.entries(bone.values).map(([quantity, { value, source }]) =>
      el(
        "tr",
        { class: source.startsWith("rule") || source.startsWith("expr") ? "deduced" : "known" },
        el("td", {}, bone.name),
        el("td", {}, quantity),
        el("td", {}, value.map((number) => Number(number.toFixed(4))).join("  ")),
        el("td", {}, source),
      ),
    );
    const unknown = bone.unknown.map((quantity) =>
      el(
        "tr",
        { class: "unknown" },
        el("td", {}, bone.name),
        el("td", {}, quantity),
        el("td", {}, "?"),
        el("td", {}, "unknown"),
      ),
    );
    return [...found, ...unknown];
  }
}

/** The button `host` opens the dialog. */
export function deducePanel(host: HTMLElement, { commands }: App): void {
  const dialog = new DeduceDialog();
  host.addEventListener("click", () => dialog.open());
  commands.add({ keys: [], words: "IK rules: deduce bones", act: () => dialog.open() });
}
