/**
 * Shows a slider for each parameter of the watched actor's machine, at its value. The slider of a parameter that keys
 * change shows in the states in which they change it.
 */

import "./parameters.css";
import { computed, effect } from "@preact/signals-core";
import { html, type TemplateResult } from "lit-html";
import { repeat } from "lit-html/directives/repeat.js";
import { live } from "lit-html/directives/live.js";
import type { MachineInfo, Parameter } from "../../net/protocol";
import { changedIn } from "../../state/keyChanges";
import { canLook, gripsOf } from "../../state/points";
import { draw } from "../../ui/draw";
import type { App } from "../../view/app";

const STEPS = 200;
/** With more sliders than this they stand in two columns. */
const MANY = 2;

/** Writes a number with three significant figures. */
export function short(value: number): string {
  return String(Number(value.toPrecision(3)));
}

/** Returns the parameters that have a slider in these states. */
function withSlider(machine: MachineInfo | null, states: readonly string[]): Parameter[] {
  // These have a button or a handle of their own, as points have.
  const others = new Set([...gripsOf(machine).values()].map(({ weight }) => weight));
  if (canLook(machine)) others.add("look");
  return (machine?.parameters ?? [])
    .filter(({ name, driven, kind }) => !driven && !others.has(name) && kind !== "point")
    .filter(({ name }) => changedIn(machine?.keys ?? {}, name, states));
}

export function parametersPanel(host: HTMLElement, { machine, parameters, selection }: App): void {
  const shown = computed(() => withSlider(machine.info.value, selection.layerStates.value));

  function row({ name, minimum, maximum }: Parameter): TemplateResult {
    const value = parameters.get(name);
    const set = ({ target }: Event): void => parameters.set(name, (target as HTMLInputElement).valueAsNumber);
    return html`<label>
      <span title=${name} .textContent=${name}></span>
      <input
        type="range"
        aria-label=${name}
        min=${minimum}
        max=${maximum}
        step=${(maximum - minimum) / STEPS || 1}
        .valueAsNumber=${live(value)}
        @input=${set}
      />
      <output .textContent=${short(value)}></output>
    </label>`;
  }

  effect(() => {
    host.hidden = !shown.value.length;
    host.classList.toggle("many", shown.value.length > MANY);
  });
  draw(host, () => html`${repeat(shown.value, ({ name }) => name, row)}`);
}
