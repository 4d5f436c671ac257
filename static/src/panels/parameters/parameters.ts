/**
 * Shows a slider for each parameter of the watched actor's machine, at its value. The slider of a parameter that keys
 * change shows in the states in which they change it.
 */

import "./parameters.css";
import type { MachineInfo, Parameter } from "../../net/protocol";
import type { ParameterValues } from "../../state/parameterValues";
import { changedIn } from "../../state/keyChanges";
import { canLook, gripsOf } from "../../state/points";
import type { Session } from "../../state/session";
import { el, say } from "../../ui/dom";

const STEPS = 200;
/** With more sliders than this they stand in two columns. */
const MANY = 2;

/** Writes a number with three significant figures. */
export function short(value: number): string {
  return String(Number(value.toPrecision(3)));
}

export class ParametersPanel {
  private readonly sliders = new Map<string, (value: number) => void>();

  constructor(
    private readonly host: HTMLElement,
    private readonly session: Session,
    private readonly values: ParameterValues,
  ) {
    session.machine.on((machine) => this.draw(machine));
    session.layerStates.on(() => this.draw(session.machine.value));
    values.changed.on((name) => this.follow(name));
  }

  private draw(machine: MachineInfo | null): void {
    this.sliders.clear();
    // These have a button or a handle of their own, as points have.
    const others = new Set([...gripsOf(machine).values()].map(({ weight }) => weight));
    if (canLook(machine)) others.add("look");
    const rows = (machine?.parameters ?? [])
      .filter(({ name, driven, kind }) => !driven && !others.has(name) && kind !== "point")
      .filter(({ name }) => changedIn(machine?.keys ?? {}, name, this.session.layerStates.value))
      .map((parameter) => this.row(parameter));
    this.host.hidden = !rows.length;
    this.host.classList.toggle("many", rows.length > MANY);
    this.host.replaceChildren(...rows);
  }

  /** Moves a slider, or all, to their values. */
  private follow(changed: string | null): void {
    for (const [name, show] of this.sliders)
      if (changed === null || changed === name) show(this.values.get(name));
  }

  private row({ name, minimum, maximum }: Parameter): HTMLElement {
    const step = (maximum - minimum) / STEPS || 1;
    const slider = el("input", { type: "range", "aria-label": name, min: minimum, max: maximum, step });
    const shown = el("output");
    const show = (value: number): void => {
      slider.valueAsNumber = value;
      say(shown, short(value));
    };
    show(this.values.get(name));
    this.sliders.set(name, show);
    slider.addEventListener("input", () => this.values.set(name, slider.valueAsNumber));
    return el("label", {}, el("span", { title: name }, name), slider, shown);
  }
}
