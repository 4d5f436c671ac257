/** Lists stages and forks as a tree: go to one, fork the watched one, name and delete them. */

import "../../ui/formField.css";
import "./stages.css";
import { effect, signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit-html";
import type { StageInfo } from "../../net/protocol";
import * as api from "../../net/stages";
import { reasonOf } from "../../net/reason";
import { nameOfStage } from "../../state/stageList";
import { draw } from "../../ui/draw";
import { focusFirst } from "../../ui/focusFirst";
import type { App } from "../../view/app";
import { ghostDifference } from "./ghostDifference";
import { leftBehindPart } from "./leftBehind";
import { lossesPart } from "./losses";
import { nowWords, originWords, type Row, spanOf, treeOf } from "./stageTree";

const READ_MS = 2000;
/** The longest name that the server takes. */
const LONGEST_NAME = 80;
/** Deeper forks are not moved further in. */
const DEEPEST = 6;

/** What a row asks for: another name, or a yes to its deletion. */
type Asked = { stage: string; about: "name" | "deletion" } | null;

export function stagesPanel(host: HTMLElement, app: App): void {
  const { commands, ghost, inspection, notices, playback, session, stage, stageList, stages } = app;
  const difference = ghostDifference(app);
  const sleepers = leftBehindPart(app, act);
  const losses = lossesPart((words) => notices.emit(words));
  const asked = signal<Asked>(null);
  const isOpen = (): boolean => inspection.drawer.value === "stages";

  /** Does something on the server, says why not, and reads the list again. */
  async function act(request: Promise<unknown>): Promise<void> {
    settle();
    await request.catch((error: unknown) => notices.emit(reasonOf(error)));
    await stageList.read();
  }

  /** Takes the question back; the focus goes to the row that asked. */
  function settle(): void {
    const row = host.querySelector<HTMLElement>("li:has(form) .stage-row");
    asked.value = null;
    row?.focus();
  }

  function ask(next: NonNullable<Asked>): void {
    asked.value = next;
    queueMicrotask(() => focusFirst(host, "li form :is(input, .keep)"));
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

  /** Shows the origin of the watched stage as its ghost, or takes the ghost away. */
  async function toggleGhost(): Promise<void> {
    if (ghost.stage.value !== null) {
      ghost.hide();
      return;
    }
    await stageList.read();
    const watched = stageList.all.value.find(({ id }) => id === stage.id);
    const origin = watched?.origin?.is_there ? watched.origin.stage : null;
    if (origin !== null) ghost.show(origin);
    else notices.emit("This stage is no fork. Choose a ghost in the list of stages (O).");
  }

  const ghostButton = (id: string, name: string): TemplateResult =>
    html`<button
      type="button"
      aria-label=${`ghost of ${name}`}
      title="show it over the watched stage, at the same tick"
      aria-pressed=${ghost.stage.value === id}
      @click=${() => (ghost.stage.value === id ? ghost.hide() : ghost.show(id))}
    >
      ghost
    </button>`;

  const deletion = (doomed: StageInfo): TemplateResult =>
    html`<form
      @submit=${(submit: Event) => {
        submit.preventDefault();
        remove(doomed);
      }}
    >
      <p .textContent=${`Delete ${nameOfStage(doomed)} for good? Its forks stay.`}></p>
      <button type="button" class="keep" @click=${settle}>keep it</button>
      <button type="submit">delete it</button>
    </form>`;

  const renaming = ({ id, name }: StageInfo): TemplateResult =>
    html`<form @submit=${(submit: Event) => void act(api.rename(id, named(submit)))}>
      <input
        name="name"
        class="text-input"
        aria-label="name of the stage"
        autocomplete="off"
        maxlength=${LONGEST_NAME}
        .defaultValue=${name}
      />
      <button type="submit">name it</button>
    </form>`;

  const actions = ({ id }: StageInfo, name: string): TemplateResult =>
    html`<div class="stage-actions">
      ${id === stage.hello.value?.stage ? nothing : ghostButton(id, name)}
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

  function row({ stage: listed, depth }: Row): TemplateResult {
    const name = nameOfStage(listed);
    const about = asked.value?.stage === listed.id ? asked.value.about : null;
    const { from, to } = spanOf(listed, stageList.all.value);
    return html`<li
      aria-current=${listed.id === stage.hello.value?.stage}
      .style=${`--depth: ${Math.min(depth, DEEPEST)}; --from: ${from}; --to: ${to}`}
    >
      <button
        type="button"
        class="stage-row"
        title="watch it"
        @click=${() => listed.id === stage.id || session.watch(listed.id)}
      >
        <b .textContent=${name}></b>
        <span .textContent=${originWords(listed, stageList.all.value)}></span>
        <small .textContent=${nowWords(listed)}></small>
      </button>
      <i class="stage-span"></i>
      ${about === null ? actions(listed, name) : about === "name" ? renaming(listed) : deletion(listed)}
    </li>`;
  }

  draw(host, () => {
    const tick = playback.looking.value;
    return html`<form class="new-fork" @submit=${fork}>
        <input
          name="name"
          class="text-input"
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
      ${losses.part()} ${sleepers()}
      <ul aria-label="stages">
        ${treeOf(stageList.all.value).map(row)}
      </ul>
      ${difference()}`;
  });
  commands.add(
    {
      keys: [],
      words: "fork the stage at the shown moment",
      act: () => void act(stages.fork(playback.looking.value, "")),
    },
    {
      keys: ["x"],
      words: "ghost of the origin of a fork: show, hide",
      act: () => void toggleGhost(),
    },
  );
  host.addEventListener("keydown", (press) => {
    if (press.key !== "Escape" || asked.value === null) return;
    settle();
    press.preventDefault();
  });
  effect(() => {
    if (isOpen()) void stageList.read();
  });
  effect(() => {
    if (stage.hello.value) void losses.read();
  });
  setInterval(() => isOpen() && void stageList.read(), READ_MS);
}
