/** Shows a dropped character before it has a machine: its picture, its clips, and what its file holds. */

import "./look.css";
import { signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit-html";
import { LoadingManager } from "three";
import { reasonOf } from "../../net/reason";
import { el } from "../../ui/dom";
import { draw } from "../../ui/draw";
import { LookedModel } from "../../view/lookedModel";
import { LookedPicture } from "../../view/lookedPicture";
import { loadModel } from "../../view/model";
import type { Quality } from "../../view/quality";
import { contents, type Facts } from "./lookContents";

/** A model that can be looked at. */
interface Shown {
  model: LookedModel;
  picture: LookedPicture;
}

const SPEEDS = [0.1, 0.25, 0.5, 1, 2];

const check = (words: string, on: boolean, change: (on: boolean) => void): TemplateResult =>
  html`<label
    ><input
      type="checkbox"
      .checked=${on}
      @change=${({ target }: Event) => change((target as HTMLInputElement).checked)}
    />
    ${words}</label
  >`;

export class Look {
  /** The picture with its controls. */
  readonly picture = el("div", { class: "look-picture" });
  /** What is in the file, folded. */
  readonly contents = el("div", { class: "look-contents" });
  private readonly shown = signal<Shown | null>(null);
  private readonly wrong = signal("");
  private readonly showsJoints = signal(false);
  private readonly ends: (() => void)[] = [];
  private readonly manager = new LoadingManager();
  private ended = false;

  constructor(
    private readonly facts: Facts,
    private readonly quality: Quality,
  ) {
    this.follow(this.picture, () => this.stageOf(this.shown.value));
    this.follow(this.contents, () => contents(facts, this.shown.value?.model ?? null));
    this.load().catch((error: unknown) => (this.wrong.value = `No picture: ${reasonOf(error)}`));
  }

  private async load(): Promise<void> {
    const url = new URL(this.facts.model.replace(/^\//, ""), document.baseURI).href;
    const model = await loadModel(url, this.manager);
    if (this.ended) return;
    const looked = new LookedModel(model);
    const picture = new LookedPicture(model, looked, this.quality);
    this.ends.push(() => picture.end());
    this.showsJoints.value = picture.showsJoints;
    this.shown.value = { model: looked, picture };
  }

  private follow(host: HTMLElement, template: () => TemplateResult): void {
    this.ends.push(draw(host, template));
  }

  /** The meshes that are hidden, by their places in the file. */
  get hidden(): string[] {
    return [...(this.shown.value?.model.hidden.value ?? [])].map(({ place }) => place).sort();
  }

  /** Ends the picture, and its loading. */
  end(): void {
    this.ended = true;
    this.manager.abort();
    this.ends.forEach((end) => end());
  }

  /** Draws a button that plays a clip, or ends it. */
  playButton(clip: string): TemplateResult {
    const { model } = this.shown.value ?? {};
    const index = this.facts.clips.findIndex(({ name }) => name === clip);
    const plays = model?.playing.value.has(index) ?? false;
    return html`<span class="look-play">
      <button
        type="button"
        class="plain square"
        ?disabled=${!model || index < 0}
        aria-label=${`play ${clip}`}
        aria-pressed=${plays}
        @click=${() => model?.toggle(index)}
        .textContent=${plays ? "■" : "▶"}
      ></button>
    </span>`;
  }

  private stageOf(shown: Shown | null): TemplateResult {
    if (!shown) return html`<p class="look-wait" role="status" .textContent=${this.wrong.value || "…"}></p>`;
    return html`${shown.picture.canvas}
      <div class="look-controls">
        ${shown.model.clips ? this.transport(shown.model) : nothing}
        ${check("joints", this.showsJoints.value, (on) => {
          this.showsJoints.value = shown.picture.showsJoints = on;
        })}
      </div>`;
  }

  private transport(model: LookedModel): TemplateResult {
    const { paused, loops, solo, speed, time, duration } = model;
    const value = ({ target }: Event): number => Number((target as HTMLInputElement).value);
    return html`<button
        type="button"
        ?disabled=${!duration.value}
        aria-pressed=${paused.value}
        @click=${() => (paused.value = !paused.value)}
      >
        pause
      </button>
      <input
        type="range"
        aria-label="time in the clip"
        min="0"
        step="any"
        .max=${String(duration.value || 1)}
        .value=${String(time.value)}
        ?disabled=${!duration.value}
        @input=${(input: Event) => model.seek(value(input))}
      />
      <output>${time.value.toFixed(2)} s</output>
      ${check("loop", loops.value, (on) => model.setLoop(on))}
      ${check("solo", solo.value, (on) => (solo.value = on))}
      <select aria-label="speed of the clips" @change=${(change: Event) => (speed.value = value(change))}>
        ${SPEEDS.map((step) => html`<option value=${step} ?selected=${step === speed.value}>${step}×</option>`)}
      </select>`;
  }
}
