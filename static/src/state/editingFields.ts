/** What is typed in the fields of a form: each text is tried while it is typed, and kept when the field is left. */

import { signal } from "@preact/signals-core";
import type { Finding, Operation } from "../net/protocol";
import { reasonOf } from "../net/reason";
import type { Answer } from "./editAnswer";
import type { Editing } from "./editing";

const TRIAL_PAUSE_MS = 180;

/** A text in a field that the server has not kept, and what is wrong with it. */
interface Draft {
  text: string;
  error: string;
  /** The verifier's, if it refuses the text. */
  findings: readonly Finding[];
  /** Whether the server has not answered yet. */
  checking: boolean;
}

const FINE: Omit<Draft, "text"> = { error: "", findings: [], checking: false };

/** A field: its value, what is wrong with it, what happens while it is typed in and when it is left. */
export interface BoundField {
  key: string;
  value: string;
  error: string;
  /** Whether the value is typed and not kept. */
  changed: boolean;
  /** The verifier's, if it refuses the text. */
  findings: readonly Finding[];
  /** Whether the server has not answered yet. */
  checking: boolean;
  typed: (text: string) => void;
  left: (text: string) => void;
  dropped: () => void;
}

/** Makes the operations of a text; throws an error with words if the text has none. */
export type Means = (text: string) => readonly Operation[];

export class EditingFields {
  private readonly drafts = signal<ReadonlyMap<string, Draft>>(new Map());
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly editing: Editing) {}

  /** Binds the field `key`, which shows `value`. */
  bind(key: string, value: string, means: Means): BoundField {
    const draft = this.drafts.value.get(key);
    return {
      key,
      value: draft?.text ?? value,
      error: draft?.error ?? "",
      changed: draft !== undefined,
      findings: draft?.findings ?? [],
      checking: draft?.checking ?? false,
      typed: (text) => this.typed(key, text, text === value, means),
      left: (text) => void this.keep(key, text, text === value, means),
      dropped: () => this.put(key, null),
    };
  }

  /** Forgets all that is not kept. */
  clear(): void {
    clearTimeout(this.timer);
    this.drafts.value = new Map();
  }

  private typed(key: string, text: string, same: boolean, means: Means): void {
    clearTimeout(this.timer);
    this.put(key, same ? { ...FINE, text } : this.unanswered(key, text));
    if (!same) this.timer = setTimeout(() => void this.try(key, text, means), TRIAL_PAUSE_MS);
  }

  private async try(key: string, text: string, means: Means): Promise<void> {
    const answer = await answered(() => this.editing.try(means(text)));
    const draft = this.drafts.value.get(key);
    if (draft?.text === text)
      this.put(key, answer ? { text, ...fault(answer) } : { ...draft, checking: false });
  }

  private async keep(key: string, text: string, same: boolean, means: Means): Promise<void> {
    clearTimeout(this.timer);
    this.put(key, same ? null : this.unanswered(key, text));
    if (same) return;
    const answer = await answered(() => this.editing.keep(means(text)));
    if (this.drafts.value.get(key)?.text !== text) return;
    this.put(key, answer?.kind === "fine" ? null : { text, ...fault(answer) });
  }

  /** What was wrong stays until the answer: what stands below the field must not move under the pointer. */
  private unanswered(key: string, text: string): Draft {
    return { ...(this.drafts.value.get(key) ?? FINE), text, checking: true };
  }

  private put(key: string, draft: Draft | null): void {
    const drafts = new Map(this.drafts.value);
    if (draft) drafts.set(key, draft);
    else drafts.delete(key);
    this.drafts.value = drafts;
  }
}

async function answered(request: () => Promise<Answer | null>): Promise<Answer | null> {
  try {
    return await request();
  } catch (error) {
    return { kind: "refused", words: reasonOf(error), findings: [] };
  }
}

function fault(answer: Answer | null): Omit<Draft, "text"> {
  if (!answer || answer.kind === "fine") return FINE;
  return { ...FINE, error: answer.findings[0]?.message ?? answer.words, findings: answer.findings };
}
