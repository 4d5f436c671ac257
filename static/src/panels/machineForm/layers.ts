/** The section of layers: what each moves, how, and how much. */

import type { LayerInfo, MachineInfo, Operation } from "../../net/protocol";
import { type Entry, movedUp, type Section } from "./entries";
import { listed, numberOrName, numberText } from "../../state/fieldTexts";

type Fields = Extract<Operation, { kind: "set_layer" }>["fields"];
const MODES = [
  ["override", "in place of the layers below"],
  ["additive", "added to the layers below"],
] as const;

export function layerSection({ layers }: MachineInfo): Section {
  const above = layers.slice(1);
  return {
    title: "layers",
    entries: above.map((layer, i) => entry(layer, above, i)),
    add: { hint: "arms", means: (layer) => [{ kind: "add_layer", layer }] },
  };
}

function entry({ name, mask, mode, weight }: LayerInfo, above: readonly LayerInfo[], at: number): Entry {
  const layer = { layer: name };
  const set = (fields: Fields): Operation[] => [{ kind: "set_layer", ...layer, fields }];
  return {
    name,
    rename: (to) => [{ kind: "rename_layer", ...layer, to }],
    fields: [
      {
        label: "joints",
        value: mask.join(", "),
        hint: "all; Spine, Head",
        means: (text) => set({ mask: listed(text).length ? listed(text) : null }),
      },
      {
        label: "mode",
        value: mode,
        choices: MODES,
        means: (text) => set({ mode: text as LayerInfo["mode"] }),
      },
      {
        label: "weight",
        value: typeof weight === "number" ? numberText(weight) : weight,
        hint: "0…1, or a parameter",
        means: (text) => set({ weight: numberOrName(text) }),
      },
    ],
    ...movedUp(above, at, (before) => ({ kind: "move_layer", ...layer, before })),
    remove: [{ kind: "delete_layer", ...layer }],
  };
}
