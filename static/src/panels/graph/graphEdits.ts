/** Edits the machine from the graph: places of states, new arrows, deleted arrows; each is one version. */

import type { LayerInfo, Operation } from "../../net/protocol";
import type { Selected } from "../../state/inspection";
import { choose } from "../../ui/chooser";
import type { App } from "../../view/app";
import { filed } from "./layerPlaces";
import type { Places, Point } from "./shapes";

/** Keeps the place of a state; the first time of all states of the layer, so that the picture stays what it is. */
export async function keepPlace({ editing, machine }: App, state: string, places: Places): Promise<boolean> {
  const [info, layer] = [machine.info.value, machine.layerInfo];
  if (!info || !layer) return false;
  const known = filed(info, layer);
  const states = new Set(layer.states.map(({ name }) => name));
  const moved = [...places].filter(([name]) => states.has(name) && (name === state || !known.has(name)));
  const positions = Object.fromEntries(
    moved.map(([name, { x, y }]): [string, number[]] => [name, [Math.round(x), Math.round(y)]]),
  );
  return editing.operate([{ kind: "set_view", layer: layer.name, positions }]);
}

/** Deletes the places of the layer's states from the file; returns whether the file has no such place now. */
export async function deletePlaces({ editing, machine }: App): Promise<boolean> {
  const [info, layer] = [machine.info.value, machine.layerInfo];
  if (!info || !layer) return false;
  const positions = Object.fromEntries([...filed(info, layer).keys()].map((name) => [name, null]));
  if (Object.keys(positions).length === 0) return true;
  return editing.operate([{ kind: "set_view", layer: layer.name, positions }]);
}

/** Asks for the event of an arrow and makes its cell; returns the event, or null if nothing was made. */
export async function makeArrow(app: App, from: string, to: string, at: Point): Promise<string | null> {
  const [info, layer] = [app.machine.info.value, app.machine.layerInfo];
  if (!info || !layer) return null;
  const choices = info.events
    .map((name) => ({ name, note: leadsTo(layer, from, name) }))
    .sort((a, b) => Number(a.note !== "") - Number(b.note !== ""));
  const title = from === to ? `${from} again on` : `${from} to ${to} on`;
  const event = await choose(title, choices, at, (typed) =>
    /^[A-Za-z_][\w-]*$/.test(typed) ? "a new event" : null,
  );
  if (event === null) return null;
  const isNew = !info.events.includes(event);
  const operations: Operation[] = [
    ...(isNew ? [{ kind: "add_event" as const, event, layer: layer.name }] : []),
    {
      kind: "set_cell",
      layer: layer.name,
      state: from,
      event,
      text: from === to ? `${to}!` : to,
      ...(layer.table[from]?.[event]?.alternatives.length ? { fields: { alternatives: null } } : {}),
    },
  ];
  return (await app.editing.operate(operations)) ? event : null;
}

/** Says where an event leads now, for the menu. */
function leadsTo({ table }: LayerInfo, state: string, event: string): string {
  const cell = table[state]?.[event];
  if (!cell) return "";
  return cell.alternatives.length
    ? `now ${cell.alternatives.length} ways`
    : cell.to
      ? `now ${cell.to}`
      : "now –";
}

/** Blanks the cell of an arrow; one that a row's or column's default gives becomes a dash, which means nothing. */
export async function deleteArrow(app: App, { layer, state, event }: Selected): Promise<boolean> {
  const info = app.machine.info.value?.layers.find(({ name }) => name === layer);
  const cell = event === null ? undefined : info?.table[state]?.[event];
  if (!cell || event === null) return false;
  const text = cell.source === "cell" ? "" : "-";
  return app.editing.operate([{ kind: "set_cell", layer, state, event, text }]);
}
