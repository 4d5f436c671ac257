/** Picks the machine or scene to watch, and the actor. */

import "./picker.css";
import { html, nothing, type TemplateResult } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { draw } from "../../ui/draw";
import type { App } from "../../view/app";

/** Marks a scene's name in the list; names of machines have no colon. */
const SCENE = "scene:";

interface Choice {
  value: string;
  words: string;
  title?: string;
}

/** Makes options; `chosen` is the value of the selected one. */
const options = (choices: readonly Choice[], chosen: string): TemplateResult[] =>
  choices.map(
    ({ value, words, title }) =>
      html`<option
        value=${value}
        title=${title ?? nothing}
        .text=${words}
        .selected=${live(value === chosen)}
      ></option>`,
  );

const MOVES = ["ArrowDown", "ArrowUp", "Home", "End", "PageDown", "PageUp"];

/** A key that would choose another machine at once opens the list, where Enter chooses. */
function openList(press: KeyboardEvent): void {
  if (!MOVES.includes(press.key)) return;
  press.preventDefault();
  (press.currentTarget as HTMLSelectElement).showPicker();
}

/** Returns choices of machines by their titles; a title that several of them have is followed by the name. */
function wellNamed(machines: readonly { name: string; title: string }[]): Choice[] {
  const isUnique = (title: string): boolean => machines.filter((one) => one.title === title).length === 1;
  return machines.map(({ name, title }) => ({
    value: name,
    words: isUnique(title) ? title : `${title} · ${name}`,
  }));
}

function machineChoice({ library, selection }: App): TemplateResult {
  const machines = wellNamed(library.machines.value.filter(({ scene }) => !scene));
  const scenes = library.scenes.value.map(({ name, title, description }) => ({
    value: SCENE + name,
    words: title,
    title: description,
  }));
  const name = selection.cast?.machine ?? "";
  const scene = library.sceneOf(name);
  const chosen = scene ? SCENE + scene : name;
  const choose = ({ target }: Event): void => {
    const { value } = target as HTMLSelectElement;
    if (value.startsWith(SCENE)) void library.openScene(value.slice(SCENE.length));
    else void library.openMachine(value);
  };
  return html`<select
    aria-label="machine"
    title="machine"
    ?hidden=${!machines.length && !scenes.length}
    @change=${choose}
    @keydown=${openList}
  >
    <optgroup label="machines">${options(machines, chosen)}</optgroup>
    ${scenes.length ? html`<optgroup label="scenes">${options(scenes, chosen)}</optgroup>` : null}
  </select>`;
}

function actorChoice({ machine, selection, stage }: App): TemplateResult {
  const actors = stage.hello.value?.casts.flatMap((cast) => cast.actors) ?? [];
  return html`<select
    aria-label="actor"
    title="actor"
    ?hidden=${actors.length < 2}
    @change=${({ target }: Event) => void machine.choose(Number((target as HTMLSelectElement).value))}
  >
    ${options(
      actors.map(({ id, name }) => ({ value: String(id), words: name })),
      String(selection.actor.value),
    )}
  </select>`;
}

export function pickerPanel(host: HTMLElement, app: App): void {
  draw(host, () => html`${machineChoice(app)}${actorChoice(app)}`);
  app.stage.hello.subscribe(() => {
    if (!app.library.machines.value.length) void app.library.read();
  });
}
