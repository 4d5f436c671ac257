/** Chooses light, exposure, shadow and background of the picture, and saves it. */

import "./scene.css";
import { html, type TemplateResult } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { BACKGROUNDS, type Background, type SceneLook } from "../../state/sceneSettings";
import { draw } from "../../ui/draw";
import type { App } from "../../view/app";
import { capture, savePicture } from "../../view/pictures";

type Amount = "environment" | "exposure";

const AMOUNTS: readonly (readonly [Amount, string, number])[] = [
  ["environment", "light around", 3],
  ["exposure", "exposure", 3],
];

const valueOf = ({ target }: Event): string => (target as HTMLInputElement).value;

export function scenePanel(host: HTMLElement, app: App): void {
  const { scene, inspection, commands, view, stage } = app;
  const { isSceneShown } = inspection;
  let opener: Element | null = null;

  function close(): void {
    isSceneShown.value = false;
    if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
    if (opener instanceof HTMLElement && opener.isConnected) opener.focus({ preventScroll: true });
  }

  function open(): void {
    opener = document.activeElement;
    isSceneShown.value = true;
    host.querySelector("input")?.focus();
  }

  const toggle = (): void => (isSceneShown.value ? close() : open());
  commands.add({ keys: ["v"], words: "light and background", act: toggle });
  isSceneShown.subscribe((shown) => (host.hidden = !shown));
  for (const kind of ["keydown", "keyup"] as const)
    host.addEventListener(kind, (press) => {
      if (kind === "keydown" && press.key === "Escape") close();
      if (press.key !== "v") press.stopPropagation();
    });
  document.addEventListener("keydown", (press) => {
    if (press.key !== "Escape" || press.target !== document.body || !isSceneShown.value) return;
    press.stopPropagation();
    close();
  });
  const save = (): void =>
    savePicture(capture(view.scene, scene.look.value.transparent), `statwalk-${stage.tick}.png`);
  commands.add({ keys: ["n"], words: "save the picture", act: save });
  const set = (part: Partial<SceneLook>): void => scene.set(part);
  draw(host, () => {
    const look = scene.look.value;
    return html`<header>
        <h2>picture</h2>
        <button type="button" class="plain square" aria-label="close" title="close (Esc)" @click=${close}>
          ×
        </button>
      </header>
      ${AMOUNTS.map(([name, words, most]) => amount(words, look[name], most, (value) => set({ [name]: value })))}
      ${check("shadow", look.shadow, (shadow) => set({ shadow }))} ${background(look, set)}
      ${check("transparent", look.transparent, (transparent) => set({ transparent }))}
      <button type="button" class="primary" title="the picture as a PNG file (N)" @click=${save}>
        save PNG
      </button>
      <button type="button" ?disabled=${!scene.isChanged.value} @click=${() => scene.reset()}>reset</button>`;
  });
}

function amount(words: string, value: number, most: number, set: (value: number) => void): TemplateResult {
  return html`<label
    ><span .textContent=${words}></span>
    <input
      type="range"
      aria-label=${words}
      min="0"
      max=${most}
      step="0.05"
      .value=${live(String(value))}
      @input=${(change: Event) => set(Number(valueOf(change)))} />
    <output .textContent=${value.toFixed(2)}></output
  ></label>`;
}

function check(words: string, value: boolean, set: (value: boolean) => void): TemplateResult {
  return html`<label
    ><span .textContent=${words}></span>
    <input
      type="checkbox"
      aria-label=${words}
      .checked=${live(value)}
      @change=${({ target }: Event) => set((target as HTMLInputElement).checked)}
  /></label>`;
}

function background(
  { background: chosen, colour }: SceneLook,
  set: (part: Partial<SceneLook>) => void,
): TemplateResult {
  return html`<label
      >background
      <select
        aria-label="background"
        @change=${(change: Event) => set({ background: valueOf(change) as Background })}
      >
        ${BACKGROUNDS.map(
          (name) => html`<option value=${name} ?selected=${name === chosen} .textContent=${name}></option>`,
        )}
      </select></label
    >
    <label ?hidden=${chosen === "theme"}
      >colour
      <input
        type="color"
        aria-label="colour"
        .value=${live(colour)}
        @input=${(change: Event) => set({ colour: valueOf(change) })}
    /></label>`;
}
