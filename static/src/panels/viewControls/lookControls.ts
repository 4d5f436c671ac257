/** Chooses how skin and tetrahedra are painted: materials, weights of a bone, normals; wire, texture. */

import { el } from "../../ui/dom";
import { controlLine } from "../../ui/popover";
import { choice } from "./choice";
import { PAINTS, SOLIDS } from "../../view/looks";
import type { StageView } from "../../view/stageView";

/** Makes the choice of the bone whose weights are shown; a click on a joint chooses, too. */
function boneChoice(stageView: StageView): HTMLSelectElement {
  const { bone, paint } = stageView.looks;
  const select = el("select", { "aria-label": "bone whose weights are shown", title: "or click a joint" });
  const fill = (): void => {
    const names = stageView.watched.model?.cast.names ?? [];
    if (paint.value === "weights" && !names.includes(bone.value)) bone.value = stageView.watched.firstBone();
    select.replaceChildren(...names.map((name) => el("option", { value: name }, name)));
    select.value = bone.value;
    select.hidden = paint.value !== "weights";
  };
  select.addEventListener("change", () => (bone.value = select.value));
  stageView.watched.ready.subscribe(fill);
  paint.subscribe(fill);
  bone.subscribe(fill);
  return select;
}

/** Makes the choices; the bone's and the tetrahedra's are shown where they matter. */
export function lookControls(stageView: StageView): HTMLElement[] {
  const { paint, solid } = stageView.looks;
  const solids = choice("tetrahedra", "how the tetrahedra are drawn", SOLIDS, solid);
  stageView.modes.subscribe(({ tetra }) => (solids.hidden = !tetra));
  const paints = choice("what the skin shows", "what the skin shows", PAINTS, paint);
  return [
    controlLine("skin shows", paints),
    controlLine("weights of", boneChoice(stageView)),
    controlLine("tetrahedra", solids),
  ];
}
