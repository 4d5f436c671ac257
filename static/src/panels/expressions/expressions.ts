/**
 * Lists the expressions of the watched actor's machine and character, and of the states that it is in: which line sets
 * what, and its present value. The machine's own lines are edited here.
 */

import "./expressions.css";
import { effect, signal } from "@preact/signals-core";
import { html, type TemplateResult } from "lit-html";
import { actorFacts } from "../../net/actors";
import type { ActorView, ExpressionView } from "../../net/types/api.generated";
import { draw } from "../../ui/draw";
import type { App } from "../../view/app";
import { ExpressionsForm } from "./form";
import { sides, valueOf } from "./lines";

const READ_MS = 500;
/** More lines than this are folded, and all on a low page: the table needs the room. */
const MANY = 12;
const TALL = window.matchMedia("(min-height: 860px)");

function row(
  number: number | null,
  name: string,
  from: string,
  formula: string,
  value: string,
): TemplateResult {
  return html`<li>
    ${
      number === null
        ? html`<span></span>`
        : html`<span
            class="line"
            title=${`line ${number} of its file`}
            .textContent=${String(number)}
          ></span>`
    }
    <b><span .textContent=${name}></span>${from ? html`<small .textContent=${from}></small>` : null}</b>
    <span class="formula" .textContent=${formula}></span>
    <output .textContent=${value}></output>
  </li>`;
}

/** Makes a row for each line of the machine and its character, then for each line of the present states. */
function rows({ machine, selection }: App, facts: ActorView | null): TemplateResult[] {
  const info = machine.info.value;
  const states = (info?.layers ?? [])
    .flatMap((layer) => layer.states)
    .filter(({ name }) => selection.layerStates.value.includes(name));
  const own = (line: ExpressionView): TemplateResult => {
    const from = line.source === "character" ? "character" : "";
    return row(line.line, line.name, from, line.formula, valueOf(line, facts));
  };
  const ofState = (line: string, state: string): TemplateResult => {
    const [target, formula] = sides(line);
    return row(null, target, state, formula, "");
  };
  return [
    ...(info?.expressions ?? []).map(own),
    ...states.flatMap(({ name, expressions }) => expressions.map((line) => ofState(line, name))),
  ];
}

function list(shown: readonly TemplateResult[]): TemplateResult {
  const words = shown.length === 1 ? "1 expression" : `${shown.length} expressions`;
  return html`<details ?open=${TALL.matches && shown.length <= MANY}>
    <summary .textContent=${words}></summary>
    <ul>
      ${shown}
    </ul>
  </details>`;
}

export function expressionsPanel(host: HTMLElement, app: App): void {
  const { selection, stage } = app;
  const facts = signal<ActorView | null>(null);
  async function read(): Promise<void> {
    const actor = selection.actor.value;
    if (host.hidden || actor === null || document.hidden) return;
    facts.value = await actorFacts(stage.id, actor).catch(() => null);
  }

  const form = new ExpressionsForm(app, () => host.querySelector("textarea")!);
  draw(
    host,
    () =>
      html`<button
          type="button"
          class="plain edit"
          ?hidden=${form.isOpen}
          .textContent=${"edit"}
          @click=${() => form.open()}
        ></button>
        ${list(rows(app, facts.value))} ${form.template()}`,
  );
  effect(() => {
    host.hidden = !rows(app, null).length;
    void read();
  });
  setInterval(() => void read(), READ_MS);
}
