/** What became of one event of a tick, from its cell to the joints. */

import type { Explained } from "../../net/explained";
import { el } from "../dom";
import { blendWords, isSeen, movedWords, outcomeWords, valueWords } from "./words";

/** A bar as long as `share` 0…1 of its box. */
function bar(share: number): HTMLElement {
  const made = el("i", { class: "moved", "aria-hidden": true });
  made.style.width = `${Math.max(2, Math.round(100 * share))}%`;
  return made;
}

function joints({ joints: all }: Explained): HTMLElement | null {
  const moved = all.filter(isSeen);
  if (!moved.length) return null;
  const size = (one: Explained["joints"][number]): number => one.degrees + 0.1 * one.millimetres;
  const most = Math.max(...moved.map(size), 1e-9);
  const items = moved.map((one) => el("li", {}, el("span", {}, one.joint), el("span", { class: "length" }, bar(size(one) / most)), el("b", {}, movedWords(one))));
  return el("ul", { class: "joints" }, ...items);
}

function cellButton({ cell, line, source, from_state: state, event }: Explained, go: (state: string, event: string) => void): HTMLElement {
  if (!cell) return el("span", {}, "no cell");
  const written = cell.join("/");
  const button = el("button", { type: "button", class: "where", title: "shows the cell in the table" }, written);
  button.addEventListener("click", () => go(state, event));
  const facts = [source && source !== "cell" ? source : "", line ? `line ${line}` : ""].filter(Boolean).join(", ");
  return el("span", {}, button, facts ? el("small", {}, ` ${facts}`) : null);
}

/** `layer`: its name, where there are several. `go` leads to a cell of the table. */
export function explanation(one: Explained, layer: string, go: (state: string, event: string) => void): HTMLElement {
  const row = (term: string, ...said: (Node | string | null)[]): HTMLElement | null => {
    const there = said.filter((part) => part !== null && part !== "");
    return there.length ? el("div", {}, el("dt", {}, term), el("dd", {}, ...there)) : null;
  };
  const head = el("h3", {}, one.event, layer ? el("small", {}, layer) : null, el("em", { "data-verdict": one.verdict }, one.verdict));
  const facts = [
    row("cell", cellButton(one, go)),
    row("values", valueWords(one.values).join(", ")),
    row("so", outcomeWords(one)),
    row("because", one.reason),
    row("blend", blendWords(one)),
    row("joints", joints(one)),
  ];
  return el("section", { class: "event-why", "data-about": one.event }, head, el("dl", {}, ...facts));
}
