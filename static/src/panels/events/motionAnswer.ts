/** Waits until a motion has answered an input: the state that the input began has ended. */

import type { ReadonlySignal } from "@preact/signals-core";

/** Milliseconds after which an input counts as answered, whatever the state does. */
const LONGEST_MS = 2500;

/** Resolves when the state has changed twice from now on. While a fork is fetched, the state is null: null counts as no change. */
export function motionAnswer(state: ReadonlySignal<number | null>): Promise<void> {
  return new Promise((done) => {
    let [before, changes] = [state.peek(), 0];
    const answered = (): void => {
      clearTimeout(timer);
      forget();
      done();
    };
    const timer = setTimeout(answered, LONGEST_MS);
    const forget = state.subscribe((now) => {
      if (now === before || now === null) return;
      before = now;
      if (++changes === 2) answered();
    });
  });
}
