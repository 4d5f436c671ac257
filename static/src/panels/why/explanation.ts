/** Shows the verdict on one event: cell, values, result, blend, joints. */

import type { Explained } from "../../net/protocol";
import { el } from "../../ui/dom";
import { blendWords, isSeen, movedWords, reasonWords, resultWords, valueWords } from "./words";

/** Makes a bar of the length `share`, 0…1. */
function bar(share: number): HTMLElement {
  const made = el("i", { class: "moved", "aria-hidden": true });
  made.style.width = `${Math.max(2, Math.round(100 * share))}%`;
  return made;
}

function joints({ joints: all }: Explained): HTMLElement | null {
  const moved = all.filter(isSeen);
  if (!moved.length) return null;
  const size = (joint: Explained["joints"][number]): number => joint.degrees + 0.1 * joint.millimetres;
  const most = Math.max(...moved.map(size), 1e-9);
  const items = moved.map((joint) =>
    el(
      "li",
      {},
      el("span", {}, joint.joint),
      el("span", { class: "length" }, bar(size(joint) / most)),
      el("b", {}, movedWords(joint)),
    ),
  );
  return el("ul", { class: "joints" }, ...items);
}

function cellButton(
  { cell, line, source, from_state: state, event }: Explained,
  go: (state: string, event: string) => void,
): HTMLElement {
  if (!cell) return el("span", {}, "no cell");
  const written = cell.join("/");
  const button = el(
    "button",
    { type: "button", class: "where", title: "shows the cell in the table" },
    written,
  );
  button.addEventListener("click", () => go(state, event));
  const facts = [source && source !== "cell" ? source : "", line ? `line ${line}` : ""]
    .filter(Boolean)
    .join(", ");
  return el("span", {}, button, facts ? el("small", {}, ` ${facts}`) : null);
}

/** `layer`: its name if the machine has several, else empty. `go` shows a cell of the table. */
export function explanation(
  explained: Explained,
  layer: string,
  go: (state: string, event: string) => void,
): HTMLElement {
  const row = (term: string, ...parts: (Node | string | null)[]): HTMLElement | null => {
    const filled = parts.filter((part) => part !== null && part !== "");
    return filled.length ? el("div", {}, el("dt", {}, term), el("dd", {}, ...filled)) : null;
  };
  const head = el(
    "h3",
    {},
    explained.event,
    layer ? el("small", {}, layer) : null,
    el("em", { "data-verdict": explained.verdict }, explained.verdict),
  );
  const facts = [
    row("cell", cellButton(explained, go)),
    row("values", valueWords(explained.values).join(", ")),
    row("so", resultWords(explained)),
    row("because", reasonWords(explained)),
    row("blend", blendWords(explained)),
    row("joints", joints(explained)),
  ];
  return el("section", { class: "event-why", "data-about": explained.event }, head, el("dl", {}, ...facts));
}
