/**
 * Lists the expressions of the watched actor's machine, with the present values of its free variables, and those of
 * the states that it is in.
 */

import "./expressions.css";
import { actorFacts } from "../../net/actors";
import type { MachineInfo } from "../../net/protocol";
import type { Session } from "../../state/session";
import { el, say } from "../../ui/dom";

const READ_MS = 500;
/** More lines than this are folded. */
const MANY = 12;

/** Splits a line at its first equals sign. */
export function sides(line: string): [string, string] {
  const at = line.indexOf("=");
  return [line.slice(0, at).trim(), line.slice(at + 1).trim()];
}

/** Writes a value with at most four digits after the point. */
export function rounded(value: number): string {
  return String(Number(value.toFixed(4)));
}

export class ExpressionsPanel {
  private readonly values = new Map<string, HTMLElement>();

  constructor(
    private readonly host: HTMLElement,
    private readonly session: Session,
  ) {
    session.machine.on((machine) => this.draw(machine));
    session.layerStates.on(() => this.draw(session.machine.value));
    session.actor.on(() => void this.read());
    setInterval(() => void this.read(), READ_MS);
  }

  private draw(machine: MachineInfo | null): void {
    const lines = machine?.expressions ?? [];
    const ofStates = (machine?.layers ?? []).flatMap(({ states }) =>
      states
        .filter(({ name }) => this.session.layerStates.value.includes(name))
        .flatMap(({ name, expressions }) => expressions.map((line) => this.row(line, name))),
    );
    this.values.clear();
    const rows = [...lines.map((line) => this.row(line, "")), ...ofStates];
    this.host.hidden = !rows.length;
    const list = el("dl", {}, ...rows);
    this.host.replaceChildren(
      ...(rows.length > MANY
        ? [el("details", {}, el("summary", {}, `${rows.length} expressions`), list)]
        : [el("h2", {}, "expressions"), list]),
    );
    void this.read();
  }

  private row(line: string, state: string): HTMLElement {
    const [target, formula] = sides(line);
    const value = el("output", {}, "");
    if (!state) this.values.set(target, value);
    const from = state ? el("small", {}, state) : null;
    return el("div", {}, el("dt", {}, target, from), el("dd", {}, formula), value);
  }

  /** Reads the values of the free variables from the actor's facts. */
  private async read(): Promise<void> {
    const actor = this.session.actor.value;
    if (this.host.hidden || actor === null || document.hidden) return;
    const facts = await actorFacts(this.session.stage, actor).catch(() => null);
    for (const [name, output] of this.values) {
      const value = facts?.variables[name];
      say(output, value === undefined ? "" : rounded(value));
    }
  }
}
