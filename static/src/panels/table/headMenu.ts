/** The menu of a row's head, of a column's head, or of the table's corner: it changes the structure of the table. */

import "../../ui/menu.css";
import "./headMenu.css";
import { effect, signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit-html";
import type { Operation } from "../../net/protocol";
import { EditingFields } from "../../state/editingFields";
import { el } from "../../ui/dom";
import { draw } from "../../ui/draw";
import { focusFirst } from "../../ui/focusFirst";
import { formField } from "../../ui/formField";
import { stepThrough } from "../../ui/menuKeys";
import type { App } from "../../view/app";
import { type Ask, type Choice, choicesOf, type Head } from "./headChoices";

/** An open menu: below which head it stands, and what it asks for. */
interface Opened {
  head: Head;
  anchor: HTMLElement;
  ask: Ask | null;
  /** What is in the way of a deletion. */
  refused: { words: string; anyway: readonly Operation[] } | null;
}

export function headMenu(host: HTMLElement, app: App): (head: Head, anchor: HTMLElement) => void {
  const opened = signal<Opened | null>(null);
  const fields = new EditingFields(app.editing);
  const box = el("div", { class: "menu head-menu", hidden: true });
  host.append(box);

  function close(back: boolean): void {
    const anchor = opened.value?.anchor;
    opened.value = null;
    fields.clear();
    if (back && anchor) focusAgain(host, anchor);
  }

  async function act(choice: Choice): Promise<void> {
    const menu = opened.value;
    if (!menu) return;
    if (choice.ask) opened.value = { ...menu, ask: choice.ask, refused: null };
    else if (choice.run) {
      close(false);
      choice.run(app);
    } else if (choice.operations) {
      const answer = await app.editing.keep(choice.operations);
      if (answer.kind === "fine") close(true);
      else {
        const words = answer.findings.map(({ message }) => message).join("\n") || answer.words;
        opened.value = { ...menu, refused: { words, anyway: choice.anyway ?? [] } };
      }
    }
  }

  const item = (choice: Choice): TemplateResult =>
    html`<button
      type="button"
      role="menuitem"
      tabindex="-1"
      ?disabled=${choice.off ?? false}
      .textContent=${choice.words}
      @click=${() => void act(choice)}
    ></button>`;

  const refusal = ({ words, anyway }: NonNullable<Opened["refused"]>): TemplateResult =>
    html`<p class="field-error" role="status" .textContent=${words}></p>
      ${anyway.length ? item({ words: "delete, and make these cells blank", operations: anyway }) : nothing}`;

  function question({ label, value, hint, proposals, operations }: Ask): TemplateResult {
    const field = fields.bind("ask", value, (text) => operations(text.trim()));
    // The field is left by Enter alone: a click elsewhere gives the question up.
    const left = (text: string): void => {
      if (text.trim() && text !== value) field.left(text);
      else close(true);
    };
    return formField({ ...field, left }, { label, ...(hint && { hint }), ...(proposals && { proposals }) });
  }

  draw(box, () => {
    const menu = opened.value;
    if (!menu) return html``;
    if (menu.ask) return question(menu.ask);
    const layer = app.machine.layerInfo;
    const choices = layer ? choicesOf(menu.head, layer, app.machine.info.value?.events ?? []) : [];
    return html`<div role="menu" aria-label=${menu.head.name || "table"}>
      ${choices.map(item)} ${menu.refused ? refusal(menu.refused) : nothing}
    </div>`;
  });
  effect(() => {
    const menu = opened.value;
    box.hidden = menu === null;
    if (!menu) return;
    place(box, menu.anchor);
    focusFirst(box, "input, [role=menuitem]:not([disabled])");
  });
  app.machine.info.subscribe(() => opened.peek()?.ask && close(true));
  box.addEventListener("keydown", (press) => {
    press.stopPropagation();
    if (press.key === "Escape" || press.key === "Tab") close(true);
    else if (!stepThrough(box, press)) return;
    press.preventDefault();
  });
  document.addEventListener("pointerdown", ({ target }) => {
    if (opened.peek() && target instanceof Node && !box.contains(target)) close(false);
  });
  return (head, anchor) => (opened.value = { head, anchor, ask: null, refused: null });
}

/** Puts the menu below its head, inside the window. */
function place(box: HTMLElement, anchor: HTMLElement): void {
  const { left, bottom, top } = anchor.getBoundingClientRect();
  const [width, height] = [box.offsetWidth, box.offsetHeight];
  const under = bottom + height < innerHeight ? bottom : Math.max(0, top - height);
  box.style.left = `${Math.max(4, Math.min(left, innerWidth - width - 4))}px`;
  box.style.top = `${under}px`;
}

/** Focuses the head that the menu belonged to; the table may have been drawn again. */
function focusAgain(host: HTMLElement, { dataset }: HTMLElement): void {
  const { state, column } = dataset;
  const heads = [...host.querySelectorAll<HTMLElement>("th[tabindex]")];
  const head = heads.find((th) => th.dataset["state"] === state && th.dataset["column"] === column);
  (head ?? heads[0])?.focus({ preventScroll: true });
}
