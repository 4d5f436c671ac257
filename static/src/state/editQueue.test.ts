import { expect, test } from "vitest";
import { EditQueue } from "./editQueue";

/** A server that answers when it is told to. */
class SlowServer {
  readonly asked: string[] = [];
  private answers: ((answer: string) => void)[] = [];

  send = (place: string, text: string, dry: boolean): Promise<string> => {
    this.asked.push(`${dry ? "try" : "keep"} ${place} ${text}`);
    return new Promise((resolve) => this.answers.push(resolve));
  };

  /** Answers the oldest request, then lets the next one be sent. */
  async answer(text: string): Promise<void> {
    this.answers.shift()!(text);
    await new Promise((resolve) => setTimeout(resolve));
  }
}

function begun(): { server: SlowServer; queue: EditQueue<string, string> } {
  const server = new SlowServer();
  return { server, queue: new EditQueue(server.send) };
}

test("the same edit is sent once, however often it is asked for", async () => {
  const { server, queue } = begun();
  const answers = [1, 2, 3, 4].map(() => queue.keep("A", "WALK"));
  await Promise.resolve();
  await server.answer("fine");
  expect(server.asked).toEqual(["keep A WALK"]);
  expect(await Promise.all(answers)).toEqual(["fine", null, null, null]);
});

test("an edit of the next cell waits for the one before", async () => {
  const { server, queue } = begun();
  const answers = [queue.keep("A", "WALK"), queue.keep("B", "STAT")];
  await Promise.resolve();
  expect(server.asked).toEqual(["keep A WALK"]);
  await server.answer("first");
  await server.answer("second");
  expect(await Promise.all(answers)).toEqual(["first", "second"]);
});

test("a trial that waits is left out where something newer was asked", async () => {
  const { server, queue } = begun();
  const answers = [queue.keep("A", "WALK"), queue.try("B", "S"), queue.try("B", "ST")];
  await Promise.resolve();
  await server.answer("kept");
  await server.answer("tried");
  expect(server.asked).toEqual(["keep A WALK", "try B ST"]);
  expect(await Promise.all(answers)).toEqual(["kept", null, "tried"]);
});

test("an edit can be asked for again after it was answered", async () => {
  const { server, queue } = begun();
  const first = queue.keep("A", "WLAK");
  await Promise.resolve();
  await server.answer("refused");
  expect(await first).toBe("refused");
  void queue.keep("A", "WLAK");
  await Promise.resolve();
  expect(server.asked).toHaveLength(2);
});

test("a request that fails does not hold up the next", async () => {
  const sent: string[] = [];
  const queue = new EditQueue<string, string>((place) => {
    sent.push(place);
    return place === "A" ? Promise.reject(new Error("the line broke")) : Promise.resolve("fine");
  });
  await expect(queue.keep("A", "WALK")).rejects.toThrow("broke");
  expect(await queue.keep("B", "WALK")).toBe("fine");
  expect(sent).toEqual(["A", "B"]);
});
