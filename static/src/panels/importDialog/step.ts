/** A step of the import dialog. */

import type { TemplateResult } from "lit-html";
import type { Look } from "./look";

export interface Step {
  title: string;
  /** Draws the step, and again when a signal changes that it reads. */
  content: () => TemplateResult;
  /** The picture in it, which ends when another step is shown. */
  look?: Look;
  /** What has the focus first; the dialog itself if it is left out. */
  focus?: string;
  /** Takes the fields of its form. */
  sent?: (fields: FormData) => void;
}

/** Returns what a step calls `answer` with that `show` shows; rejects when the dialog is closed. */
export function asked<Answer>(
  signal: AbortSignal,
  show: (answer: (value: Answer) => void) => void,
): Promise<Answer> {
  return new Promise((resolve, reject) => {
    signal.addEventListener("abort", () => reject(new DOMException("aborted", "AbortError")));
    show(resolve);
  });
}
