/** The part of the list that deletes at once all stages that somebody has left behind. */

import { signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit-html";
import type { StageInfo } from "../../net/protocol";
import { nameOfStage } from "../../state/stageList";
import { plural } from "../../ui/amounts";
import type { App } from "../../view/app";

/** The most stages that the question names. */
const MOST_NAMES = 8;

/** Returns the stages that sleep, without a name; not `watched`, and none in which a fork began. */
export function leftBehind(stages: readonly StageInfo[], watched: string): StageInfo[] {
  const origins = new Set(stages.map(({ origin }) => origin?.stage));
  return stages.filter(({ id, name, asleep }) => asleep && !name && id !== watched && !origins.has(id));
}

/** Says which stages would go, and what with them. */
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
  const isAsked = signal(false);

  /** Asks, or takes the question back; the focus goes along. */
  function ask(asked: boolean): void {
    isAsked.value = asked;
    queueMicrotask(() => document.querySelector<HTMLElement>("#left-behind button")?.focus());
  }

  async function remove(doomed: readonly StageInfo[]): Promise<void> {
    isAsked.value = false;
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
      <button type="button" @click=${() => ask(false)}>keep them</button>
      <button type="submit">delete them</button>
    </form>`;

  return (): TemplateResult | typeof nothing => {
    const doomed = leftBehind(stageList.all.value, stage.hello.value?.stage ?? "main");
    if (!doomed.length) return nothing;
    const words = `Asleep and without a name: ${plural(doomed.length, "stage")}.`;
    return html`<section id="left-behind">
      <p .textContent=${words}></p>
      ${isAsked.value ? asking(doomed) : html`<button type="button" @click=${() => ask(true)}>delete them …</button>`}
    </section>`;
  };
}
