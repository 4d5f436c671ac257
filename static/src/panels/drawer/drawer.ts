/** A drawer over the view, opened on demand: one tab for each part of the workbench. */

import "./drawer.css";
import { effect } from "@preact/signals-core";
import { html } from "lit-html";
import { keyName } from "../../state/commands";
import type { Drawer } from "../../state/inspection";
import { byId } from "../../ui/dom";
import { draw } from "../../ui/draw";
import { keepInSight } from "../../ui/keepInSight";
import type { App } from "../../view/app";

/** The stages and the people have commands of their own. */
const COMMANDS: readonly (readonly [NonNullable<Drawer>, string])[] = [
  ["cell", "inspect the selected cell or state"],
  ["machine", "machine: states, events, layers, parameters, keys"],
  ["versions", "versions of the machine"],
  ["text", "YAML of the machine"],
];

const TABS: readonly (readonly [NonNullable<Drawer>, string])[] = [
  ["cell", "cell"],
  ["machine", "machine"],
  ["versions", "versions"],
  ["text", "YAML"],
  ["stages", "stages"],
  ["people", "people"],
];

export function drawerPanel(host: HTMLElement, app: App): void {
  const { drawer } = app.inspection;
  app.view.scene.leaveRoomBeside(host);
  keepInSight(host);
  const parts = [...host.querySelectorAll<HTMLElement>("[data-drawer]")];
  let opener: Element | null = null;
  const close = (): void => {
    drawer.value = null;
    // The browser itself takes the focus from hidden elements only at its next drawing: keys would be lost.
    if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
    if (opener instanceof HTMLElement && opener.isConnected) opener.focus({ preventScroll: true });
  };
  for (const part of parts) Object.assign(part, { role: "tabpanel", tabIndex: -1 });
  for (const [name, words] of COMMANDS)
    app.commands.add({ keys: [], words, act: () => (drawer.value = name) });
  effect(() => {
    if (drawer.value !== null && host.hidden) opener = document.activeElement;
    host.hidden = drawer.value === null;
    host.dataset["shown"] = drawer.value ?? "";
    for (const part of parts) part.hidden = part.dataset["drawer"] !== drawer.value;
  });
  draw(
    byId("drawer-tabs"),
    () =>
      html`<div role="tablist" aria-label="workbench" @keydown=${turned}>
          ${TABS.map(
            ([name, words]) =>
              html`<button
                type="button"
                role="tab"
                aria-selected=${drawer.value === name}
                tabindex=${drawer.value === name ? 0 : -1}
                .textContent=${words}
                @click=${() => (drawer.value = name)}
              ></button>`,
          )}
        </div>
        <button type="button" class="plain square" aria-label="close" title="close (Esc)" @click=${close}>
          ×
        </button>`,
  );
  // A phone has no room for all tabs.
  effect(() => {
    const chosen = drawer.value && host.querySelector('[role="tab"][aria-selected="true"]');
    if (chosen) chosen.scrollIntoView({ block: "nearest", inline: "nearest" });
  });
  const isForThePage = (press: KeyboardEvent): boolean =>
    (press.ctrlKey || press.metaKey) &&
    (["z", "y"].includes(press.key.toLowerCase()) || app.commands.of(keyName(press)) !== undefined);
  // Keys in the drawer are for its fields, not for the character; Ctrl and a key act as everywhere.
  for (const kind of ["keydown", "keyup"] as const)
    host.addEventListener(kind, (press) => {
      if (kind === "keydown" && press.key === "Escape" && !press.defaultPrevented) close();
      if (!isForThePage(press)) press.stopPropagation();
    });
  document.addEventListener("keydown", (press) => {
    if (press.key !== "Escape" || press.target !== document.body || drawer.value === null) return;
    press.stopPropagation();
    close();
  });
}

/** Moves to the tab beside the focused one by the arrow keys. */
function turned(press: KeyboardEvent): void {
  const step = { ArrowLeft: -1, ArrowRight: 1 }[press.key];
  const list = press.currentTarget as HTMLElement;
  if (step === undefined) return;
  const tabs = [...list.querySelectorAll<HTMLElement>("[role=tab]")];
  const next = tabs[(tabs.indexOf(press.target as HTMLElement) + step + tabs.length) % tabs.length];
  next?.click();
  next?.focus();
}
