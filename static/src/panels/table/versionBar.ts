/** Shows the version, the last edit and the number of findings above the table, and a button to undo. */

import { effect } from "@preact/signals-core";
import type { App } from "../../view/app";
import { el, say } from "../../ui/dom";
import { countWords } from "./findings";
import { reasonOf } from "../../net/reason";

export class VersionBar {
  private readonly version = el("b", { class: "version" });
  private readonly what = el("span", { class: "what" });
  private readonly findings = el("button", {
    type: "button",
    class: "plain count",
    title: "what the verifier says of the table",
  });
  private readonly measure = el(
    "button",
    {
      type: "button",
      class: "plain",
      title: "play every transition, and measure it: feet, knees, hands, jumps",
    },
    "measure",
  );
  private readonly undo = el(
    "button",
    { type: "button", class: "undo", title: "the version before (Ctrl+Z)" },
    "undo",
  );

  constructor(
    host: HTMLElement,
    private readonly app: App,
    showFindings: () => void,
  ) {
    host.append(this.version, this.what, this.findings, this.measure, this.undo);
    this.findings.addEventListener("click", showFindings);
    this.measure.addEventListener("click", () => void this.measured());
    this.undo.addEventListener("click", () => void app.editing.undo());
    window.addEventListener("keydown", (press) => this.pressed(press));
    effect(() => this.show());
  }

  private async measured(): Promise<void> {
    this.measure.disabled = true;
    say(this.measure, "measuring …");
    const words = await this.app.editing.measure().catch(reasonOf);
    this.app.notices.emit(words);
    say(this.measure, "measure");
    this.measure.disabled = false;
  }

  private pressed(press: KeyboardEvent): void {
    const typing = press.target instanceof HTMLInputElement && press.target.type === "text";
    if (
      typing ||
      press.key.toLowerCase() !== "z" ||
      !(press.ctrlKey || press.metaKey) ||
      press.shiftKey ||
      this.undo.disabled
    )
      return;
    press.preventDefault();
    void this.app.editing.undo();
  }

  private show(): void {
    const machine = this.app.machine.info.value;
    const newest = this.app.editing.newest.value;
    if (!machine) return;
    say(this.version, `v${machine.version}`);
    const kept = machine.saved === "file" ? "in machine.yaml" : "by the server, not in its file";
    const edited = machine.version > 1 && newest?.version === machine.version;
    say(this.what, edited ? `${newest.what}, kept ${kept}` : `edits are kept ${kept}`);
    this.what.title = this.what.textContent;
    const words = countWords(this.app.editing.findings.value);
    say(this.findings, words === "nothing is wrong" ? "✓" : words);
    this.findings.setAttribute("aria-label", `findings: ${words}`);
    this.undo.disabled = machine.version < 2 || (edited && newest.before === 0);
  }
}
