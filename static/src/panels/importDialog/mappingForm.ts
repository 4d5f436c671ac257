/**
 * The form that maps clips to states. Names of clips come from files of strangers, so they are set as text.
 */

import "./mappingForm.css";
import type { Mapping } from "../../net/protocol";
import { el, say } from "../../ui/dom";

const LONGEST_STATE = 80;
const LIST = "state-names";

interface Row {
  clip: string;
  input: HTMLInputElement;
  /** The state's meaning, or its error. */
  says: HTMLElement;
}

/** The server names a row by the first 80 letters of its clip. */
const fieldOf = (clip: string): string => `mapping.${Array.from(clip).slice(0, 80).join("")}`;

export class MappingForm {
  readonly element: HTMLElement;
  private readonly rows: Row[];
  private readonly meanings: Record<string, string>;

  /** `before` returns what stands before a clip's name. */
  constructor({ mapping, meanings }: Mapping, before: (clip: string) => HTMLElement) {
    this.meanings = meanings;
    this.rows = Object.entries(mapping).map(([clip, state], i) => this.row(clip, state, i));
    const known = el(
      "datalist",
      { id: LIST },
      ...Object.entries(meanings).map(([state, meaning]) => el("option", { value: state }, meaning)),
    );
    const head = el(
      "div",
      { class: "map-row map-head", "aria-hidden": "true" },
      el("span"),
      el("span", {}, "clip"),
      el("span"),
      el("span", {}, "state"),
      el("span"),
    );
    const rows = this.rows.map(({ clip, input, says }) => {
      const name = el("label", { class: "map-clip", for: input.id, title: clip }, clip);
      return el(
        "div",
        { class: "map-row" },
        before(clip),
        name,
        el("span", { class: "map-arrow", "aria-hidden": "true" }, "→"),
        input,
        says,
      );
    });
    this.element = el("div", { class: "map" }, head, ...rows, known);
  }

  private row(clip: string, state: string, index: number): Row {
    const says = el("span", { class: "map-says", id: `says-${index}` });
    const facts = {
      id: `state-${index}`,
      list: LIST,
      maxlength: LONGEST_STATE,
      spellcheck: "false",
      autocomplete: "off",
      placeholder: "left out",
    };
    const input = el("input", { type: "text", "aria-describedby": says.id, ...facts });
    input.value = state;
    const row = { clip, input, says };
    input.addEventListener("input", () => this.explain(row));
    this.explain(row);
    return row;
  }

  private explain({ input, says }: Row): void {
    input.removeAttribute("aria-invalid");
    const meaning = Object.hasOwn(this.meanings, input.value) ? this.meanings[input.value]! : "";
    input.classList.toggle("known", meaning !== "");
    say(says, meaning);
  }

  /** Returns the state of each clip; empty if a clip is left out. */
  states(): Record<string, string> {
    return Object.fromEntries(this.rows.map(({ clip, input }) => [clip, input.value.trim()]));
  }

  /** Shows an error beside its clip; returns false if `field` is not in this form. */
  refuse(field: string, message: string): boolean {
    const row = this.rows.find(({ clip }) => fieldOf(clip) === field);
    if (!row) return false;
    row.input.setAttribute("aria-invalid", "true");
    say(row.says, message);
    row.input.focus();
    return true;
  }
}
