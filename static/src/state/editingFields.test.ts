import { expect, test, vi } from "vitest";
import type { Answer } from "./editAnswer";
import { EditingFields } from "./editingFields";
import type { Editing } from "./editing";

const FINE: Answer = { kind: "fine", words: "", findings: [] };
const REFUSED: Answer = { kind: "refused", words: "WLK is no state", findings: [] };

function fields(answer: Answer): { form: EditingFields; kept: unknown[] } {
  const kept: unknown[] = [];
  const keep = (operations: unknown): Promise<Answer> => {
    kept.push(operations);
    return Promise.resolve(answer);
  };
  const editing = { keep, try: () => Promise.resolve(answer) } as unknown as Editing;
  return { form: new EditingFields(editing), kept };
}

const bind = (form: EditingFields) =>
  form.bind("name", "WALK", (to) => [{ kind: "rename_state", state: "WALK", layer: "base", to }]);
const settled = (): Promise<unknown> => new Promise((done) => setTimeout(done));

test("a text is kept when its field is left", async () => {
  const { form, kept } = fields(FINE);
  bind(form).left("STROLL");
  await settled();
  expect(kept).toEqual([[{ kind: "rename_state", state: "WALK", layer: "base", to: "STROLL" }]]);
  expect(bind(form).value).toBe("WALK");
});

test("a refused text stays in its field, with the reason", async () => {
  const { form } = fields(REFUSED);
  bind(form).left("WLK");
  await settled();
  expect(bind(form)).toMatchObject({ value: "WLK", error: "WLK is no state" });
});

test("the reason is there while the text is typed", async () => {
  vi.useFakeTimers();
  const { form, kept } = fields(REFUSED);
  bind(form).typed("WLK");
  await vi.runAllTimersAsync();
  vi.useRealTimers();
  expect(bind(form).error).toBe("WLK is no state");
  expect(kept).toEqual([]);
});

test("a typed text is being checked until the answer", async () => {
  vi.useFakeTimers();
  const { form } = fields(REFUSED);
  bind(form).typed("WLK");
  const before = bind(form).checking;
  await vi.runAllTimersAsync();
  vi.useRealTimers();
  expect([before, bind(form).checking]).toEqual([true, false]);
});

test("a check that a newer one of another field replaces ends, and what was wrong stays", async () => {
  vi.useFakeTimers();
  const answers: (Answer | null)[] = [REFUSED, null];
  const form = new EditingFields({ try: () => Promise.resolve(answers.shift()) } as unknown as Editing);
  for (const text of ["WLK", "WLKK"]) {
    bind(form).typed(text);
    await vi.runAllTimersAsync();
  }
  vi.useRealTimers();
  expect(bind(form)).toMatchObject({ checking: false, error: "WLK is no state" });
});

test("the old text again is no edit", async () => {
  const { form, kept } = fields(FINE);
  bind(form).typed("WALKS");
  bind(form).left("WALK");
  await settled();
  expect(kept).toEqual([]);
});

test("a text without a meaning says why", async () => {
  const { form } = fields(FINE);
  const field = form.bind("blend", "0.2", () => {
    throw new Error("seconds are a number");
  });
  field.left("soon");
  await settled();
  expect(form.bind("blend", "0.2", () => []).error).toBe("seconds are a number");
});
