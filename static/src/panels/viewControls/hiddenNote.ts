/** Says that nothing of the character is drawn, with the button that shows it again. */

import type { Modes, StageView } from "../../view/stageView";
import { el } from "../../ui/dom";

const isHidden = ({ skin, wire, bones, tetra }: Modes): boolean => !(skin || wire || bones || tetra);

export function hiddenNote({ modes }: Pick<StageView, "modes">): HTMLElement {
  const show = el("button", { type: "button" }, "show the skin");
  const note = el(
    "div",
    { class: "group said", role: "status", hidden: true },
    "the character is hidden",
    show,
  );
  show.addEventListener("click", () => (modes.value = { ...modes.value, skin: true }));
  modes.subscribe((shown) => (note.hidden = !isHidden(shown)));
  return note;
}
