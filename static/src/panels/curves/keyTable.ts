/** The keys as a table of numbers that you edit, and some examples to start from. */

import { el } from "../../ui/dom";

export interface Key {
  time: number;
  x_deg: number;
  y_deg: number;
  z_deg: number;
  weight: number;
}

const MOST_KEYS = 32;
const FIELDS: readonly { name: keyof Key; words: string; min: number; max: number; step: number }[] = [
  { name: "time", words: "time, s", min: 0, max: 60, step: 0.05 },
  { name: "x_deg", words: "x°", min: -3600, max: 3600, step: 5 },
  { name: "y_deg", words: "y°", min: -3600, max: 3600, step: 5 },
  { name: "z_deg", words: "z°", min: -3600, max: 3600, step: 5 },
  { name: "weight", words: "weight", min: 0.001, max: 1000, step: 0.5 },
];

const key = (time: number, x_deg: number, y_deg: number, z_deg: number, weight = 1): Key => ({
  time,
  x_deg,
  y_deg,
  z_deg,
  weight,
});

export const EXAMPLES: Readonly<Record<string, readonly Key[]>> = {
  "a wave": [
    key(0, 0, 0, 0),
    key(0.6, 0, 0, 40),
    key(1.2, 0, 0, -15),
    key(1.8, 0, 0, 35, 4),
    key(3, 0, 0, 0),
  ],
  "about all axes": [
    key(0, 0, 0, 0),
    key(1, 25, 20, 0),
    key(2, -10, 35, 30),
    key(3, 20, 5, 45),
    key(4, 0, 0, 0),
  ],
  "far apart": [key(0, 0, 0, 0), key(2, 80, 80, 80)],
  "uneven times": [key(0, 0, 0, 0), key(0.2, 0, 20, 0), key(2.5, 0, 60, 0), key(3, 0, 0, 0)],
};

/** Says what is wrong with keys; an empty text if nothing is. */
export function fault(keys: readonly Key[]): string {
  if (keys.length < 2) return "two keys are needed";
  if (keys.length > MOST_KEYS) return `at most ${MOST_KEYS} keys`;
  for (const [row, one] of keys.entries()) {
    const wrong = FIELDS.find(
      ({ name, min, max }) => !(Number.isFinite(one[name]) && one[name] >= min && one[name] <= max),
    );
    if (wrong) return `key ${row + 1}: ${wrong.words} should be ${wrong.min} to ${wrong.max}`;
    const before = keys[row - 1];
    if (before && one.time < before.time + 0.001) return `key ${row + 1}: times should rise`;
  }
  return "";
}

export class KeyTable {
  private keys: Key[];

  constructor(
    private readonly root: HTMLElement,
    examples: HTMLElement,
    first: readonly Key[],
    private readonly changed: (keys: readonly Key[]) => void,
  ) {
    this.keys = first.map((one) => ({ ...one }));
    for (const [name, keys] of Object.entries(EXAMPLES)) {
      const button = el("button", { type: "button" }, name);
      button.addEventListener("click", () => this.take(keys));
      examples.append(button);
    }
    this.fill();
  }

  take(keys: readonly Key[]): void {
    this.keys = keys.map((one) => ({ ...one }));
    this.fill();
  }

  /** Gives a key another time. */
  move(row: number, time: number): void {
    const one = this.keys[row];
    if (one) one.time = time;
    this.fill();
  }

  private fill(): void {
    const head = el("tr", {}, ...FIELDS.map(({ words }) => el("th", { scope: "col" }, words)), el("td"));
    const rows = this.keys.map((one, row) => this.row(one, row));
    this.root.replaceChildren(el("table", {}, el("thead", {}, head), el("tbody", {}, ...rows)));
    if (this.keys.length < MOST_KEYS) this.root.append(this.adder());
    this.changed(this.keys);
  }

  private row(one: Key, row: number): HTMLElement {
    const cells = FIELDS.map(({ name, words, min, max, step }) => {
      const label = `${words} of key ${row + 1}`;
      const input = el("input", {
        type: "number",
        min,
        max,
        step: "any",
        value: one[name],
        "aria-label": label,
      });
      input.addEventListener("input", () => {
        one[name] = input.valueAsNumber;
        this.changed(this.keys);
      });
      input.addEventListener("keydown", (press) => {
        if (press.key !== "ArrowUp" && press.key !== "ArrowDown") return;
        press.preventDefault();
        const next = input.valueAsNumber + (press.key === "ArrowUp" ? step : -step);
        input.valueAsNumber = Number(Math.min(max, Math.max(min, next)).toFixed(3));
        input.dispatchEvent(new Event("input"));
      });
      return el("td", {}, input);
    });
    const gone = el(
      "button",
      { type: "button", class: "plain square", "aria-label": `remove key ${row + 1}` },
      "×",
    );
    gone.addEventListener("click", () => {
      this.keys.splice(row, 1);
      this.fill();
    });
    return el("tr", {}, ...cells, el("td", {}, gone));
  }

  private adder(): HTMLElement {
    const add = el("button", { type: "button" }, "add a key");
    add.addEventListener("click", () => {
      const last = this.keys.at(-1) ?? key(-1, 0, 0, 0);
      this.keys.push({ ...last, time: Number((last.time + 1).toFixed(3)) });
      this.fill();
    });
    return add;
  }
}
