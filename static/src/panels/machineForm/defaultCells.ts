/** Finds the default rows and columns of a layer, and opens the form of one. */

import { html, type TemplateResult } from "lit-html";
import type { LayerInfo } from "../../net/protocol";
import type { App } from "../../view/app";

/** Returns the places of all defaults that the table has, as STATE and EVENT with a `*`. */
export function defaultPlaces({ table }: LayerInfo): [string, string][] {
  const cells = Object.values(table).flatMap((row) => Object.values(row));
  const places = cells.filter(({ written }) => written.some((name) => name.endsWith("*")));
  const distinct = new Map(places.map(({ written }) => [written.join("/"), written]));
  return [...distinct.values()].map(([state, event]) => [state, event]);
}

export function defaultCells({ inspection, machine }: App): TemplateResult {
  const layer = machine.layerInfo;
  if (!layer) return html``;
  const open = (state: string, event: string): void => {
    inspection.selected.value = { layer: layer.name, state, event };
    inspection.drawer.value = "cell";
  };
  const words = (name: string, all: string): string => (name === "*" ? all : name);
  const choose = ({ target }: Event): void => {
    const [state = "*", event = "*"] = (target as HTMLSelectElement).value.split("\n");
    open(state, event);
  };
  const known = defaultPlaces(layer);
  const others = [
    ["*", "*"] as const,
    ...layer.states.map(({ name }) => [name, "*"] as const),
    ...(machine.info.value?.events ?? []).map((event) => ["*", event] as const),
  ].filter(([state, event]) => !known.some(([row, column]) => row === state && column === event));
  const text = (state: string, event: string): string =>
    `${words(state, "every state")}, ${words(event, "every event")}`;
  return html`<details data-section="rows and columns">
    <summary>
      <span>default rows and columns</span><output .textContent=${String(known.length)}></output>
    </summary>
    ${known.map(
      ([state, event]) =>
        html`<button
          type="button"
          class="wide"
          .textContent=${text(state, event)}
          @click=${() => open(state, event)}
        ></button>`,
    )}
    <div class="field">
      <label for="new-default">new</label>
      <select id="new-default" .value=${""} @change=${choose}>
        <option value="" .textContent=${"for …"}></option>
        ${others.map(
          ([state, event]) =>
            html`<option value=${`${state}\n${event}`} .textContent=${text(state, event)}></option>`,
        )}
      </select>
    </div>
  </details>`;
}
