/** The menu beside the picker: makes a machine, copies, renames, exports and deletes the shown one. */

import "../../ui/menu.css";
import "./machineMenu.css";
import { effect, signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit-html";
import * as machines from "../../net/machines";
import { reasonOf } from "../../net/reason";
import { el } from "../../ui/dom";
import { draw } from "../../ui/draw";
import { focusFirst } from "../../ui/focusFirst";
import { stepThrough } from "../../ui/menuKeys";
import type { App } from "../../view/app";
import { unplayed } from "./unplayed";

/** The server's rule for names. The browser checks a name before the page leaves its stage for a new name. */
const NAMES = { pattern: "[A-Za-z0-9][A-Za-z0-9_\\-]{0,63}", title: "letters, digits, - and _; no space" };

/** The figure of a new machine: the one in the picture, with its clips, or a simple skeleton. */
type Figure = "shown" | "simple";

/**
 * A question: its words, the name that is proposed, if it asks for one, whether it asks for a figure, and what a yes
 * does.
 */
interface Ask {
  words: string;
  yes: string;
  proposal: string | null;
  asksFigure?: boolean;
  act: (name: string) => Promise<unknown>;
}

/** Returns a name that no machine has: `walker-2`. */
export function freeName(name: string, taken: readonly string[]): string {
  if (!taken.includes(name)) return name;
  const stem = name.replace(/-\d+$/, "");
  for (let number = 2; ; number++) if (!taken.includes(`${stem}-${number}`)) return `${stem}-${number}`;
}

export function machineMenuPanel(host: HTMLElement, app: App): void {
  const { library, machine, notices, commands } = app;
  const isOpen = signal(false);
  const ask = signal<Ask | null>(null);
  const typed = signal("");
  const figure = signal<Figure>("shown");
  const error = signal("");

  function close(): void {
    isOpen.value = false;
    ask.value = null;
    host.querySelector<HTMLElement>("button")?.focus();
  }

  function question(next: Ask): void {
    [typed.value, error.value] = [next.proposal ?? "", ""];
    ask.value = next;
  }

  async function answer(): Promise<void> {
    try {
      await ask.value?.act(typed.value.trim());
      close();
      await library.read();
    } catch (reason) {
      error.value = reasonOf(reason);
    }
  }

  /** Makes a machine under the name that was typed, and watches it. */
  function making(words: string, proposal: string, make: (name: string) => Promise<unknown>): Ask {
    const act = async (name: string): Promise<void> => {
      if (taken().includes(name))
        throw new Error(`A machine is called ${name} already: choose another name.`);
      await make(name);
      await library.openMachine(name);
    };
    return { words, yes: "make it", proposal, act };
  }

  function renaming(name: string): Ask {
    const rename = (to: string): Promise<unknown> => unplayed(app, name, () => machines.rename(name, to));
    return { ...making("new name", name, rename), yes: "rename it" };
  }

  function deletion(name: string): Ask {
    const act = async (): Promise<void> => {
      await unplayed(app, name, () => machines.remove(name));
      notices.emit(`${name} is deleted.`);
    };
    return { words: `Delete ${name} and its versions?`, yes: "delete it", proposal: null, act };
  }

  function copying(name: string): Ask {
    const copyName = freeName(`${name}-copy`, taken());
    return making("name of the copy", copyName, (to) => machines.copy(to, name));
  }

  const taken = (): string[] => library.machines.value.map((other) => other.name);
  const beginning = (): Ask => {
    const shown = machine.info.value?.character ?? "";
    const make = (name: string): Promise<unknown> =>
      figure.value === "shown" ? machines.fromFigure(name, shown) : machines.fromNothing(name);
    return { ...making("name", freeName("machine", taken()), make), asksFigure: true };
  };
  const questions: readonly (readonly [string, (name: string) => Ask])[] = [
    ["delete …", deletion],
    ["copy and change …", copying],
    ["new, from nothing …", beginning],
    ["rename …", renaming],
  ];

  function choices(name: string): TemplateResult {
    const [remove, ...others] = questions.map(
      ([words, made]) =>
        html`<button
          type="button"
          role="menuitem"
          .textContent=${words}
          @click=${() => question(made(name))}
        ></button>`,
    );
    return html`<div role="menu" aria-label="machine">
      ${others}
      <a role="menuitem" href=${machines.zipAddress(name)} download @click=${close}>export .zip</a>
      ${remove}
    </div>`;
  }

  /** A command about the shown machine. */
  const command = (words: string, act: (name: string) => void): void =>
    commands.add({
      keys: [],
      words: `machine: ${words}`,
      act: () => machine.info.value && act(machine.info.value.name),
    });
  for (const [words, made] of questions)
    command(words, (name) => {
      isOpen.value = true;
      question(made(name));
    });
  command("export .zip", (name) => el("a", { href: machines.zipAddress(name), download: "" }).click());

  function figureField(): TemplateResult {
    const chosen = ({ target }: Event): void =>
      void (figure.value = (target as HTMLSelectElement).value as Figure);
    return html`<label>
      <span>figure</span>
      <select @change=${chosen}>
        <option value="shown" ?selected=${figure.value === "shown"}>
          the one that you see, with its clips
        </option>
        <option value="simple" ?selected=${figure.value === "simple"}>
          a simple skeleton, without clips
        </option>
      </select>
    </label>`;
  }

  function form({ words, yes, proposal, asksFigure }: Ask): TemplateResult {
    const submitted = (submit: Event): void => {
      submit.preventDefault();
      void answer();
    };
    const input = ({ target }: Event): void => void (typed.value = (target as HTMLInputElement).value);
    return html`<form @submit=${submitted}>
      ${
        proposal === null
          ? html`<p>${words}</p>`
          : html`<label>
              <span>${words}</span>
              <input
                class="text-input"
                required
                maxlength="64"
                pattern=${NAMES.pattern}
                title=${NAMES.title}
                autocomplete="off"
                .value=${typed.value}
                @input=${input}
              />
            </label>`
      }
      ${asksFigure ? figureField() : nothing}
      <p role="alert" ?hidden=${!error.value}>${error.value}</p>
      <button type="submit" class="primary">${yes}</button>
    </form>`;
  }

  draw(host, () => {
    const name = machine.info.value?.name ?? "";
    const toggle = (): void => void (isOpen.value = !isOpen.value);
    const content = (): TemplateResult => (ask.value ? form(ask.value) : choices(name));
    return html`<button
        type="button"
        class="plain square"
        aria-label="machine menu"
        title="new machine, copy, rename, export, delete"
        aria-haspopup="menu"
        aria-expanded=${isOpen.value}
        ?disabled=${!name}
        @click=${toggle}
      >
        ⋯
      </button>
      ${isOpen.value ? html`<div class="menu machine-menu">${content()}</div>` : nothing}`;
  });
  effect(() => {
    const first = ask.value ? "form input, form button" : "[role=menuitem]";
    if (isOpen.value) queueMicrotask(() => focusFirst(host, first));
  });
  host.addEventListener("keydown", (press) => {
    if (!isOpen.value) return;
    press.stopPropagation();
    if (press.key === "Escape") close();
    else if (stepThrough(host, press)) press.preventDefault();
  });
  document.addEventListener("pointerdown", ({ target }) => {
    if (target instanceof Node && !host.contains(target)) isOpen.value = false;
    if (!isOpen.value) ask.value = null;
  });
}
