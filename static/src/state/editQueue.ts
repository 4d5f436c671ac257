/** Sends edits one at a time and in order, so that a trial never arrives after the edit that it tries. */

export type Send<Place, Answer> = (place: Place, text: string, dry: boolean) => Promise<Answer>;

export class EditQueue<Place, Answer> {
  private last: Promise<unknown> = Promise.resolve();
  /** Counts requests: a waiting trial is left out if a newer request follows. */
  private newest = 0;
  private keeping = "";

  constructor(private readonly send: Send<Place, Answer>) {}

  /** Tries `text` without keeping it; returns null if a newer request follows. */
  async try(place: Place, text: string): Promise<Answer | null> {
    const number = ++this.newest;
    const answer = await this.next(async () =>
      number === this.newest ? this.send(place, text, true) : null,
    );
    return number === this.newest ? answer : null;
  }

  /** Keeps `text`; returns null if the same edit is already being sent. */
  async keep(place: Place, text: string): Promise<Answer | null> {
    const edit = JSON.stringify([place, text]);
    if (edit === this.keeping) return null;
    this.newest++;
    this.keeping = edit;
    try {
      return await this.next(() => this.send(place, text, false));
    } finally {
      if (this.keeping === edit) this.keeping = "";
    }
  }

  private next<T>(request: () => Promise<T>): Promise<T> {
    const answer = this.last.then(request);
    this.last = answer.catch(() => undefined);
    return answer;
  }
}
