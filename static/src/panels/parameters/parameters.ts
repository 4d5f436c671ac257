/** Shows a slider for each parameter of the watched actor's machine, at the value that was sent last. */

import "./parameters.css";
import { setParameter } from "../../net/actors";
import type { MachineInfo, Parameter } from "../../net/protocol";
import { canLook, gripsOf } from "../../state/points";
import type { Session } from "../../state/session";
import { el, say } from "../../ui/dom";

const STEPS = 200;

/** Writes a number with three significant figures. */
export function short(value: number): string {
  return String(Number(value.toPrecision(3)));
}

export class ParametersPanel {
  /** The value sent last for each actor and parameter. */
  private readonly sent = new Map<string, number>();
  private readonly sending = new Set<HTMLInputElement>();

  constructor(
    private readonly host: HTMLElement,
    private readonly session: Session,
  ) {
    session.machine.on((machine) => this.draw(machine));
    session.actor.on(() => this.draw(session.machine.value));
  }

  private draw(machine: MachineInfo | null): void {
    // These have a button or a handle of their own, as points have.
    const others = new Set([...gripsOf(machine).values()].map(({ weight }) => weight));
    if (canLook(machine)) others.add("look");
    const rows = (machine?.parameters ?? [])
      .filter(({ name, driven, kind }) => !driven && !others.has(name) && kind !== "point")
      .map((parameter) => this.row(parameter));
    this.host.hidden = !rows.length;
    this.host.replaceChildren(...rows);
  }

  /** Shows a value that was set elsewhere on the page. */
  show(name: string, value: number): void {
    this.sent.set(this.key(name), value);
    const slider = this.host.querySelector<HTMLInputElement>(`input[aria-label="${CSS.escape(name)}"]`);
    if (!slider) return;
    slider.value = String(value);
    say(slider.nextElementSibling!, short(value));
  }

  private key(name: string): string {
    return JSON.stringify([this.session.stage, this.session.actor.value, name]);
  }

  private row({ name, default: standard, minimum, maximum }: Parameter): HTMLElement {
    const value = this.sent.get(this.key(name)) ?? standard;
    const range = { min: minimum, max: maximum, step: (maximum - minimum) / STEPS || 1, value };
    const slider = el("input", { type: "range", "aria-label": name, ...range });
    const shown = el("output", {}, short(value));
    slider.addEventListener("input", () => {
      say(shown, short(slider.valueAsNumber));
      void this.send(name, slider);
    });
    return el("label", {}, el("span", {}, name), slider, shown);
  }

  /**
   * Sends the slider's value. Values that come during a request wait, and only the newest of them is sent.
   */
  private async send(name: string, slider: HTMLInputElement): Promise<void> {
    const actor = this.session.actor.value;
    if (actor === null || this.sending.has(slider)) return;
    this.sending.add(slider);
    let value: number;
    do {
      value = slider.valueAsNumber;
      this.sent.set(this.key(name), value);
      await this.session.command((stage) => setParameter(stage, actor, name, value));
    } while (slider.valueAsNumber !== value);
    this.sending.delete(slider);
  }
}
