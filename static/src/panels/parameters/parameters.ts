/**
 * Shows a slider for each parameter of the watched actor's machine, at its value. The slider of a parameter that keys
 * change shows in the states in which they change it.
 */

import "./parameters.css";
import type { MachineInfo, Parameter } from "../../net/protocol";
import { changedIn } from "../../state/keyChanges";
import { canLook, gripsOf } from "../../state/points";
import type { App } from "../../view/app";
import { el, say } from "../../ui/dom";

const STEPS = 200;
/** With more sliders than this they stand in two columns. */
const MANY = 2;

/** Writes a number with three significant figures. */
export function short(value: number): string {
  return String(Number(value.toPrecision(3)));
}

class ParametersPanel {
  private readonly sliders = new Map<string, (value: number) => void>();

  constructor(
    private readonly host: HTMLElement,
    private readonly app: App,
  ) {
    app.machine.info.subscribe((machine) => this.draw(machine));
    app.selection.layerStates.subscribe(() => this.draw(app.machine.info.value));
    app.parameters.changed.on((name) => this.follow(name));
  }

  private draw(machine: MachineInfo | null): void {
    this.sliders.clear();
    // These have a button or a handle of their own, as points have.
    const others = new Set([...gripsOf(machine).values()].map(({ weight }) => weight));
    if (canLook(machine)) others.add("look");
    const rows = (machine?.parameters ?? [])
      .filter(({ name, driven, kind }) => !driven && !others.has(name) && kind !== "point")
      .filter(({ name }) => changedIn(machine?.keys ?? {}, name, this.app.selection.layerStates.value))
      .map((parameter) => this.row(parameter));
    this.host.hidden = !rows.length;
    this.host.classList.toggle("many", rows.length > MANY);
    this.host.replaceChildren(...rows);
  }

  /** Moves a slider, or all, to their values. */
  private follow(changed: string | null): void {
    for (const [name, show] of this.sliders)
      if (changed === null || changed === name) show(this.app.parameters.get(name));
  }

  private row({ name, minimum, maximum }: Parameter): HTMLElement {
    const step = (maximum - minimum) / STEPS || 1;
    const slider = el("input", { type: "range", "aria-label": name, min: minimum, max: maximum, step });
    const shown = el("output");
    const show = (value: number): void => {
      slider.valueAsNumber = value;
      say(shown, short(value));
    };
    show(this.app.parameters.get(name));
    this.sliders.set(name, show);
    slider.addEventListener("input", () => this.app.parameters.set(name, slider.valueAsNumber));
    return el("label", {}, el("span", { title: name }, name), slider, shown);
  }
}

export function parametersPanel(host: HTMLElement, app: App): void {
  new ParametersPanel(host, app);
}
