/** Lists stages and forks as a tree: go to one, fork the watched one, name and delete them. */

import "./stages.css";
import { effect, signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit-html";
import type { StageInfo } from "../../net/protocol";
import * as api from "../../net/stages";
import { reasonOf } from "../../net/reason";
import { nameOf } from "../../state/stageList";
import { draw } from "../../ui/draw";
import type { App } from "../../view/app";
import { nowWords, originWords, type Row, treeOf } from "./stageTree";

const READ_MS = 2000;
/** The longest name that the server takes. */
const LONGEST_NAME = 80;

/** What a row asks for: another name, or a yes to its deletion. */
type Asked = { stage: string; about: "name" | "deletion" } | null;

export function stagesPanel(host: HTMLElement, app: App): void {
  const { inspection, notices, playback, session, stage, stageList, stages } = app;
  const asked = signal<Asked>(null);
  const isOpen = (): boolean => inspection.drawer.value === "stages";

  /** Does something on the server, says why not, and reads the list again. */
  async function act(request: Promise<unknown>): Promise<void> {
    asked.value = null;
    await request.catch((error: unknown) => notices.emit(reasonOf(error)));
    await stageList.read();
  }

  function ask(next: NonNullable<Asked>): void {
    asked.value = next;
    queueMicrotask(() => host.querySelector<HTMLElement>("li form :is(input, .keep)")?.focus());
  }

  function named(submit: Event): string {
    submit.preventDefault();
    const form = submit.target as HTMLFormElement;
    const name = form.elements.namedItem("name") as HTMLInputElement;
    const text = name.value.trim();
    form.reset();
    return text;
  }

  const fork = (submit: Event): void => void act(stages.fork(playback.looking.value, named(submit)));

  function remove({ id, origin }: StageInfo): void {
    void act(stages.discard(id, origin?.is_there ? origin.stage : "main"));
  }

  const deletion = (one: StageInfo): TemplateResult =>
    html`<form
      @submit=${(submit: Event) => {
        submit.preventDefault();
        remove(one);
      }}
    >
      <p .textContent=${`Delete ${nameOf(one)} for good? Its forks stay.`}></p>
      <button type="button" class="keep" @click=${() => (asked.value = null)}>keep it</button>
      <button type="submit">delete it</button>
    </form>`;

  const renaming = ({ id, name }: StageInfo): TemplateResult =>
    html`<form @submit=${(submit: Event) => void act(api.rename(id, named(submit)))}>
      <input
        name="name"
        aria-label="name of the stage"
        autocomplete="off"
        maxlength=${LONGEST_NAME}
        .defaultValue=${name}
      />
      <button type="submit">name it</button>
    </form>`;

  const actions = ({ id }: StageInfo, name: string): TemplateResult =>
    html`<div class="stage-actions">
      <button type="button" aria-label=${`rename ${name}`} @click=${() => ask({ stage: id, about: "name" })}>
        rename
      </button>
      ${
        id === "main"
          ? nothing
          : html`<button
              type="button"
              aria-label=${`delete ${name}`}
              @click=${() => ask({ stage: id, about: "deletion" })}
            >
              delete
            </button>`
      }
    </div>`;

  function row({ stage: one, depth }: Row): TemplateResult {
    const name = nameOf(one);
    const about = asked.value?.stage === one.id ? asked.value.about : null;
    return html`<li
      aria-current=${one.id === stage.hello.value?.stage}
      style=${`--depth: ${Math.min(depth, 6)}`}
    >
      <button
        type="button"
        class="stage-row"
        title="watch it"
        @click=${() => one.id === stage.id || session.watch(one.id)}
      >
        <b .textContent=${name}></b>
        <span .textContent=${originWords(one, stageList.all.value)}></span>
        <small .textContent=${nowWords(one)}></small>
      </button>
      ${about === null ? actions(one, name) : about === "name" ? renaming(one) : deletion(one)}
    </li>`;
  }

  draw(host, () => {
    const tick = playback.looking.value;
    return html`<form class="new-fork" @submit=${fork}>
        <input
          name="name"
          aria-label="name of the fork"
          placeholder="name of the fork"
          autocomplete="off"
          maxlength=${LONGEST_NAME}
        />
        <button
          type="submit"
          class="primary"
          .textContent=${tick === null ? "fork now" : `fork at ${tick}`}
        ></button>
      </form>
      <ul aria-label="stages">
        ${treeOf(stageList.all.value).map(row)}
      </ul>`;
  });
  host.addEventListener("keydown", (press) => {
    if (press.key !== "Escape" || asked.value === null) return;
    asked.value = null;
    press.preventDefault();
  });
  effect(() => {
    if (isOpen()) void stageList.read();
  });
  setInterval(() => isOpen() && void stageList.read(), READ_MS);
}
