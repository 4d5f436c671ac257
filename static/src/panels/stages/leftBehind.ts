/** The part of the list that deletes all sleeping stages without a name at once. */

import { signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit-html";
import type { StageInfo } from "../../net/protocol";
import { nameOfStage } from "../../state/stageList";
import { plural } from "../../ui/amounts";
import type { App } from "../../view/app";

/** The most stages that the question names. */
const MOST_NAMES = 8;

/** Returns the sleeping stages without a name; not the `watched` stage, and no stage in which a fork began. */
export function leftBehind(stages: readonly StageInfo[], watched: string): StageInfo[] {
  const origins = new Set(stages.map(({ origin }) => origin?.stage));
  return stages.filter(({ id, name, asleep }) => asleep && !name && id !== watched && !origins.has(id));
}

/** Names the stages that would be deleted, and counts their inputs. */
function question(doomed: readonly StageInfo[]): string {
  const more = doomed.length - MOST_NAMES;
  const names =
    doomed.slice(0, MOST_NAMES).map(nameOfStage).join(", ") + (more > 0 ? ` and ${more} more` : "");
  const inputs = doomed.reduce((sum, stage) => sum + stage.inputs, 0);
  return `Delete ${names} for good, with ${plural(inputs, "input")}?`;
}

export function leftBehindPart(
  { stage, stageList, stages }: App,
  act: (request: Promise<unknown>) => Promise<void>,
) {
  /** The stages that the question names: no other stage is deleted, though more may fall asleep meanwhile. */
  const asked = signal<ReadonlySet<string>>(new Set());

  /** Asks about stages, or takes the question back (none); the focus goes along. */
  function ask(about: readonly StageInfo[]): void {
    asked.value = new Set(about.map(({ id }) => id));
    queueMicrotask(() => document.querySelector<HTMLElement>("#left-behind button")?.focus());
  }

  async function remove(doomed: readonly StageInfo[]): Promise<void> {
    asked.value = new Set();
    await act(Promise.all(doomed.map(({ id }) => stages.discard(id, "main"))));
  }

  const asking = (doomed: readonly StageInfo[]): TemplateResult =>
    html`<form
      @submit=${(submit: Event) => {
        submit.preventDefault();
        void remove(doomed);
      }}
    >
      <p .textContent=${question(doomed)}></p>
      <button type="button" @click=${() => ask([])}>keep them</button>
      <button type="submit">delete them</button>
    </form>`;

  return (): TemplateResult | typeof nothing => {
    const asleep = leftBehind(stageList.all.value, stage.hello.value?.stage ?? "main");
    if (!asleep.length) return nothing;
    const named = asleep.filter(({ id }) => asked.value.has(id));
    return html`<section id="left-behind">
      <p .textContent=${`Asleep and without a name: ${plural(asleep.length, "stage")}.`}></p>
      ${named.length ? asking(named) : html`<button type="button" @click=${() => ask(asleep)}>delete them …</button>`}
    </section>`;
  };
}
