/** The form that maps clips to states. Names of clips come from files of strangers, so they are set as text. */

import "./mappingForm.css";
import { type Signal, signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit-html";
import type { Mapping } from "../../net/protocol";

const LONGEST_STATE = 80;

/** The server names a row by the first 80 letters of its clip. */
const fieldOf = (clip: string): string => `mapping.${Array.from(clip).slice(0, 80).join("")}`;

export class MappingForm {
  private readonly typed: Signal<ReadonlyMap<string, string>>;
  private readonly errors = signal<ReadonlyMap<string, string>>(new Map());
  private readonly meanings: ReadonlyMap<string, string>;

  /** `before` draws what stands before a clip's name. */
  constructor(
    { mapping, meanings }: Mapping,
    private readonly before: (clip: string) => TemplateResult,
  ) {
    this.typed = signal<ReadonlyMap<string, string>>(new Map(Object.entries(mapping)));
    this.meanings = new Map(Object.entries(meanings));
  }

  part(): TemplateResult {
    return html`<div class="map">
      <div class="map-row map-head" aria-hidden="true">
        <span></span><span>clip</span><span></span><span>state</span><span></span>
      </div>
      ${[...this.typed.value].map(([clip, state], i) => this.row(clip, state, i))}
      <datalist id="state-names">
        ${[...this.meanings].map(
          ([state, meaning]) => html`<option value=${state} .textContent=${meaning}></option>`,
        )}
      </datalist>
    </div>`;
  }

  private row(clip: string, state: string, index: number): TemplateResult {
    const [error, meaning] = [this.errors.value.get(clip), this.meanings.get(state) ?? ""];
    const type = ({ target }: Event): void => {
      this.typed.value = new Map(this.typed.value).set(clip, (target as HTMLInputElement).value);
      this.errors.value = new Map([...this.errors.value].filter(([wrong]) => wrong !== clip));
    };
    return html`<div class="map-row">
      ${this.before(clip)}
      <label class="map-clip" for=${`state-${index}`} title=${clip} .textContent=${clip}></label>
      <span class="map-arrow" aria-hidden="true">→</span>
      <input
        id=${`state-${index}`}
        class=${meaning ? "known" : ""}
        type="text"
        list="state-names"
        maxlength=${LONGEST_STATE}
        spellcheck="false"
        autocomplete="off"
        placeholder="left out"
        aria-describedby=${`says-${index}`}
        aria-invalid=${error === undefined ? nothing : "true"}
        .value=${state}
        @input=${type}
      />
      <span class="map-says" id=${`says-${index}`} .textContent=${error ?? meaning}></span>
    </div>`;
  }

  /** Returns the state of each clip; empty if a clip is left out. */
  states(): Record<string, string> {
    return Object.fromEntries([...this.typed.value].map(([clip, state]) => [clip, state.trim()]));
  }

  /** Takes away the errors of the last try. */
  forgive(): void {
    this.errors.value = new Map();
  }

  /** Shows an error beside its clip; returns false if `field` is not in this form. */
  refuse(field: string, message: string): boolean {
    const clips = [...this.typed.value.keys()];
    const index = clips.findIndex((clip) => fieldOf(clip) === field);
    if (index < 0) return false;
    this.errors.value = new Map(this.errors.value).set(clips[index]!, message);
    document.getElementById(`state-${index}`)?.focus();
    return true;
  }
}
