import { expect, test } from "vitest";
import { EditQueue } from "./editQueue";

/** A server that answers when it is told to. */
class SlowServer {
  readonly asked: string[] = [];
  private answers: { resolve: (answer: string) => void; reject: (error: Error) => void }[] = [];

  send = (edit: string, key: string | null): Promise<string> => {
    this.asked.push(`${key === null ? "try" : "keep"} ${edit}`);
    return new Promise((resolve, reject) => this.answers.push({ resolve, reject }));
  };

  /** Answers the oldest request, then lets the next one be sent. */
  async answer(text: string): Promise<void> {
    this.answers.shift()!.resolve(text);
    await new Promise((resolve) => setTimeout(resolve));
  }

  async fail(error: Error): Promise<void> {
    this.answers.shift()!.reject(error);
    await new Promise((resolve) => setTimeout(resolve));
  }
}

class Shelf {
  constructor(public text: string | null = null) {}
  getItem = (): string | null => this.text;
  setItem = (_: string, text: string): void => void (this.text = text);
}

function begun(storage = new Shelf()): { server: SlowServer; queue: EditQueue<string, string> } {
  const server = new SlowServer();
  const unheard = (error: unknown): boolean => error instanceof TypeError;
  const rest = (): Promise<void> => Promise.resolve();
  return { server, queue: new EditQueue({ send: server.send, unheard, rest, storage }) };
}

test("the same edit is sent once, however often it is asked for", async () => {
  const { server, queue } = begun();
  const answers = [1, 2, 3, 4].map(() => queue.keep("A WALK"));
  await Promise.resolve();
  await server.answer("fine");
  expect(server.asked).toEqual(["keep A WALK"]);
  expect(await Promise.all(answers)).toEqual(["fine", "fine", "fine", "fine"]);
});

test("an edit of the next cell waits for the one before", async () => {
  const { server, queue } = begun();
  const answers = [queue.keep("A WALK"), queue.keep("B STAT")];
  await Promise.resolve();
  expect(server.asked).toEqual(["keep A WALK"]);
  await server.answer("first");
  await server.answer("second");
  expect(await Promise.all(answers)).toEqual(["first", "second"]);
});

test("is busy until the server has answered all, unless it is away", async () => {
  const { server, queue } = begun();
  const answers = [queue.keep("A WALK"), queue.try("B S")];
  await Promise.resolve();
  expect(queue.isBusy).toBe(true);
  await server.fail(new TypeError("away"));
  expect(queue.isBusy).toBe(false);
  await server.answer("first");
  expect(queue.isBusy).toBe(true);
  await server.answer("second");
  await Promise.all(answers);
  expect(queue.isBusy).toBe(false);
});

test("a trial that waits is left out where something newer was asked", async () => {
  const { server, queue } = begun();
  const answers = [queue.keep("A WALK"), queue.try("B S"), queue.try("B ST")];
  await Promise.resolve();
  await server.answer("kept");
  await server.answer("tried");
  expect(server.asked).toEqual(["keep A WALK", "try B ST"]);
  expect(await Promise.all(answers)).toEqual(["kept", null, "tried"]);
});

test("an edit can be asked for again after it was answered", async () => {
  const { server, queue } = begun();
  const first = queue.keep("A WLAK");
  await Promise.resolve();
  await server.answer("refused");
  expect(await first).toBe("refused");
  void queue.keep("A WLAK");
  await Promise.resolve();
  expect(server.asked).toHaveLength(2);
});

test("an edit that fails does not hold up the next", async () => {
  const { server, queue } = begun();
  const answers = [queue.keep("A WALK"), queue.keep("B WALK")];
  await Promise.resolve();
  const failed = expect(answers[0]).rejects.toThrow("broke");
  await server.fail(new Error("broke"));
  await server.answer("fine");
  await failed;
  expect(await answers[1]).toBe("fine");
});

test("an edit that nobody answered is sent again, before the next", async () => {
  const { server, queue } = begun();
  const answers = [queue.keep("A WALK"), queue.keep("B WALK")];
  await Promise.resolve();
  await server.fail(new TypeError("the server is away"));
  expect(queue.away.value).toBe(true);
  await server.answer("first");
  await server.answer("second");
  expect(server.asked).toEqual(["keep A WALK", "keep A WALK", "keep B WALK"]);
  expect(await Promise.all(answers)).toEqual(["first", "second"]);
  expect(queue.away.value).toBe(false);
});

test("an edit outlives the page until it is answered", async () => {
  const storage = new Shelf();
  void begun(storage).queue.keep("A WALK");
  const { server, queue } = begun(storage);
  const told: Promise<string>[] = [];
  queue.resume((answer) => told.push(answer));
  await Promise.resolve();
  await server.answer("fine");
  expect(await Promise.all(told)).toEqual(["fine"]);
  expect(server.asked).toEqual(["keep A WALK"]);
  expect(storage.text).toBe("[]");
});

test("an edit that is sent again has the key that it had", () => {
  const storage = new Shelf();
  void begun(storage).queue.keep("A WALK");
  const [{ key }] = JSON.parse(storage.text!) as [{ key: string }];
  begun(storage).queue.resume(() => undefined);
  expect(JSON.parse(storage.text!)).toEqual([{ key, edit: "A WALK" }]);
});
