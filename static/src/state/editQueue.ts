/**
 * Sends edits one at a time and in order, so that a trial never arrives after the edit that it tries. An edit waits
 * here until the server has answered it, also while the server is away or the page is loaded again.
 */

import { signal } from "@preact/signals-core";
import { newKey } from "../net/once";

export interface Waiting<Edit> {
  /** Tells the server that an edit which is sent again is still the same. */
  readonly key: string;
  readonly edit: Edit;
}

/** How a queue sends edits. */
export interface Sender<Edit, Answer> {
  /** Sends an edit, or (`key` is null) tries it. */
  send: (edit: Edit, key: string | null) => Promise<Answer>;
  /** Returns whether this failure left the edit without an answer. */
  unheard: (error: unknown) => boolean;
  /** Waits before an edit is sent again. */
  rest: () => Promise<void>;
  storage: Pick<Storage, "getItem" | "setItem">;
}

const PLACE = "statwalk edits";

export class EditQueue<Edit, Answer> {
  /** The edits that the server has not answered yet, oldest first. */
  readonly waiting = signal<readonly Waiting<Edit>[]>([]);
  /** Whether the server did not answer the oldest of them. */
  readonly away = signal(false);
  private last: Promise<unknown> = Promise.resolve();
  private newest: { text: string; answer: Promise<Answer> } | null = null;
  /** Counts requests: a waiting trial is left out if a newer request follows. */
  private count = 0;
  private unanswered = 0;

  constructor(private readonly sender: Sender<Edit, Answer>) {}

  /** Sends what an earlier life of the page left behind; `told` gets each answer. */
  resume(told: (answer: Promise<Answer>) => void): void {
    const left = JSON.parse(this.sender.storage.getItem(PLACE) ?? "[]") as Waiting<Edit>[];
    for (const waiting of left) told(this.enqueue(waiting));
  }

  /** Tries an edit without keeping it; returns null if a newer request follows. */
  async try(edit: Edit): Promise<Answer | null> {
    const number = ++this.count;
    const answer = await this.next(async () => (number === this.count ? this.sender.send(edit, null) : null));
    return number === this.count ? answer : null;
  }

  /** Keeps an edit. The same edit again, before the first one is answered, is one edit. */
  keep(edit: Edit): Promise<Answer> {
    const text = JSON.stringify(edit);
    if (this.newest?.text === text) return this.newest.answer;
    this.count++;
    const answer = this.enqueue({ key: newKey(), edit });
    const newest = (this.newest = { text, answer });
    const answered = (): void => {
      if (this.newest === newest) this.newest = null;
    };
    answer.then(answered, answered);
    return answer;
  }

  /** Runs another request after all that wait. */
  next<T>(request: () => Promise<T>): Promise<T> {
    this.unanswered++;
    const answer = this.last.then(request);
    this.last = answer.catch(() => undefined).finally(() => this.unanswered--);
    return answer;
  }

  /** Whether the server is about to answer an edit or a trial. */
  get isBusy(): boolean {
    return this.unanswered > 0 && !this.away.value;
  }

  private enqueue(waiting: Waiting<Edit>): Promise<Answer> {
    this.remember([...this.waiting.value, waiting]);
    return this.next(async () => {
      try {
        return await this.untilHeard(waiting);
      } finally {
        this.away.value = false;
        this.remember(this.waiting.value.filter((other) => other !== waiting));
      }
    });
  }

  private async untilHeard({ edit, key }: Waiting<Edit>): Promise<Answer> {
    for (;;) {
      try {
        return await this.sender.send(edit, key);
      } catch (error) {
        if (!this.sender.unheard(error)) throw error;
      }
      this.away.value = true;
      await this.sender.rest();
    }
  }

  private remember(waiting: readonly Waiting<Edit>[]): void {
    this.waiting.value = waiting;
    this.sender.storage.setItem(PLACE, JSON.stringify(waiting));
  }
}
