/** The button that compares the GPU's skin with the server's, and the difference in words. */

import type { SkinProof } from "../../view/skinProof";
import { el, say } from "../../ui/dom";

const WAITS = "comparing …";

/** `0.0000041` (metres) -> `GPU and server differ by at most 0.004 mm`. */
export function differenceWords(difference: number | string): string {
  if (typeof difference === "string") return difference || WAITS;
  return `GPU and server differ by at most ${(1000 * difference).toFixed(3)} mm`;
}

export function proofControls({ on, difference }: SkinProof): [HTMLButtonElement, HTMLElement] {
  const title =
    "compares the vertices that your GPU poses with the server's, of the watched actor in every frame";
  const button = el("button", { type: "button", title }, "prove");
  const words = el("output", { class: "group said", hidden: true });
  button.addEventListener("click", () => (on.value = !on.value));
  on.subscribe((proving) => {
    button.setAttribute("aria-pressed", String(proving));
    words.hidden = !proving;
  });
  difference.subscribe((value) => say(words, differenceWords(value)));
  return [button, words];
}
