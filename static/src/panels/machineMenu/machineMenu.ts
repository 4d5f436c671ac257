/** The menu beside the picker: makes a machine, copies, renames, exports and deletes the shown one. */

import "./machineMenu.css";
import { effect, signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit-html";
import * as machines from "../../net/machines";
import { reasonOf } from "../../net/reason";
import { draw } from "../../ui/draw";
import { formField } from "../../ui/formField";
import type { App } from "../../view/app";

/** What asks for a name: words, the name that is proposed, and what is done with it. */
interface Ask {
  words: string;
  proposal: string;
  act: (name: string) => Promise<unknown>;
}

/** Returns a name that no machine has: `walker-2`. */
export function freeName(name: string, taken: readonly string[]): string {
  if (!taken.includes(name)) return name;
  const stem = name.replace(/-\d+$/, "");
  for (let number = 2; ; number++) if (!taken.includes(`${stem}-${number}`)) return `${stem}-${number}`;
}

export function machineMenuPanel(host: HTMLElement, app: App): void {
  const { library, machine, notices } = app;
  const isOpen = signal(false);
  const ask = signal<Ask | null>(null);
  const typed = signal("");
  const error = signal("");

  function close(): void {
    isOpen.value = false;
    ask.value = null;
    host.querySelector<HTMLElement>("button")?.focus();
  }

  function question(next: Ask): void {
    [typed.value, error.value] = [next.proposal, ""];
    ask.value = next;
  }

  async function answer(name: string): Promise<void> {
    try {
      await ask.value?.act(name);
      close();
      await library.read();
      await library.openMachine(name);
    } catch (reason) {
      error.value = reasonOf(reason);
    }
  }

  async function remove(name: string): Promise<void> {
    close();
    await leave(app);
    await machines.remove(name).then(
      () => notices.emit(`${name} is deleted.`),
      (reason: unknown) => notices.emit(reasonOf(reason)),
    );
    await library.read();
  }

  function choices(name: string): TemplateResult {
    const taken = library.machines.value.map((other) => other.name);
    const item = (words: string, act: () => void): TemplateResult =>
      html`<button type="button" role="menuitem" .textContent=${words} @click=${act}></button>`;
    return html`<div role="menu" aria-label="machine">
      ${item("copy and change …", () =>
        question({
          words: "copy",
          proposal: freeName(`${name}-copy`, taken),
          act: (to) => machines.copy(to, name),
        }),
      )}
      ${item("new, from nothing …", () =>
        question({ words: "new", proposal: freeName("machine", taken), act: machines.fromNothing }),
      )}
      ${item("rename …", () =>
        question({
          words: "name",
          proposal: name,
          act: async (to) => {
            await leave(app);
            await machines.rename(name, to);
          },
        }),
      )}
      <a role="menuitem" href=${machines.zipAddress(name)} download @click=${close}>export .zip</a>
      ${item("delete", () => void remove(name))}
    </div>`;
  }

  function nameField({ words, proposal }: Ask): TemplateResult {
    const typing = {
      key: "machine-name",
      value: typed.value,
      error: error.value,
      typed: (text: string) => (typed.value = text),
      left: (text: string) => (typed.value = text),
      dropped: () => (typed.value = proposal),
    };
    return html`<form
      @submit=${(submit: Event) => (submit.preventDefault(), void answer(typed.value.trim()))}
    >
      ${formField(typing, { label: words })}
      <button type="submit" class="primary">make it</button>
    </form>`;
  }

  draw(host, () => {
    const name = machine.info.value?.name ?? "";
    const toggle = (): void => void (isOpen.value = !isOpen.value);
    const content = (): TemplateResult => (ask.value ? nameField(ask.value) : choices(name));
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
      ${isOpen.value ? html`<div class="machine-menu">${content()}</div>` : nothing}`;
  });
  effect(() => {
    const asked = ask.value !== null;
    if (!isOpen.value) return;
    host.querySelector<HTMLElement>(asked ? "input" : "[role=menuitem]")?.focus();
  });
  host.addEventListener("keydown", (press) => {
    if (!isOpen.value) return;
    press.stopPropagation();
    if (press.key === "Escape") close();
    else moveFocus(host, press);
  });
  document.addEventListener("pointerdown", ({ target }) => {
    if (target instanceof Node && !host.contains(target)) isOpen.value = false;
    if (!isOpen.value) ask.value = null;
  });
}

function moveFocus(host: HTMLElement, press: KeyboardEvent): void {
  const items = [...host.querySelectorAll<HTMLElement>("[role=menuitem]")];
  const step = { ArrowDown: 1, ArrowUp: -1 }[press.key];
  if (step === undefined || !items.length) return;
  const at = items.indexOf(document.activeElement as HTMLElement);
  items[(at + step + items.length) % items.length]!.focus();
  press.preventDefault();
}

/** Watches the main stage, and waits until it is there: a machine on a stage can't be renamed or deleted. */
function leave({ session, stage }: App): Promise<void> {
  if (stage.id === "main") return Promise.resolve();
  session.watch("main");
  return new Promise((done) => {
    const end = stage.hello.subscribe((hello) => {
      if (hello?.stage !== "main") return;
      queueMicrotask(() => end());
      done();
    });
  });
}
