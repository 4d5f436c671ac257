// @vitest-environment happy-dom
import { beforeEach, expect, test } from "vitest";
import { el } from "../../ui/dom";
import { TableBody } from "./tableBody";

const LINE = 27;
let host: HTMLElement;
let body: TableBody;

function row(state: string): HTMLTableRowElement {
  return el("tr", {}, el("td", { "data-state": state, tabindex: -1 }, state));
}

/** Fills the body with states; what is drawn of `edited` differs. */
function fill(edited = ""): void {
  const states = Array.from({ length: 300 }, (_, i) => `S${i}`);
  const text = (name: string): string => (name === edited ? `${name}, edited` : name);
  body.fill(
    states.map((name) => ({ name, isState: true, text: () => text(name), draw: () => row(text(name)) })),
  );
}

beforeEach(() => {
  host = document.body.appendChild(el("div"));
  body = new TableBody(host);
  host.append(el("table", {}, body.element));
  fill();
});

function scroll(line: number): void {
  host.scrollTop = line * LINE;
  host.dispatchEvent(new Event("scroll"));
}

const drawn = (): string[] => [...body.rows()].map(([state]) => state);

test("rows come into sight and go, and their room stays", () => {
  scroll(100);
  expect(drawn()).toContain("S100");
  expect(drawn()).not.toContain("S0");
  const rooms = [...body.element.querySelectorAll<HTMLElement>(".gap td")].map(({ style }) => style.height);
  expect(rooms).toEqual([`${90 * LINE}px`, `${(300 - 111) * LINE}px`]);
});

test("the row with the focus stays when it is scrolled out of sight", () => {
  const cell = body.row("S5")!.cells[0]!;
  cell.tabIndex = 0;
  cell.focus();
  scroll(200);
  expect(document.activeElement).toBe(cell);
  expect(drawn().slice(0, 2)).toEqual(["S5", "S190"]);
});

test("a row out of sight is drawn when it is asked for", () => {
  expect(body.row("S250")?.textContent).toBe("S250");
  expect(body.row("NONE")).toBeNull();
});

test("an edit draws its row again, and leaves the others and their room", () => {
  scroll(100);
  const before = [...body.element.children];
  fill("S100");
  const after = [...body.element.children];
  const changed = after.filter((element) => !before.includes(element) && !element.classList.contains("gap"));
  expect(changed.map(({ textContent }) => textContent)).toEqual(["S100, edited"]);
  expect(after.map(({ className }) => className)).toEqual(before.map(({ className }) => className));
});
