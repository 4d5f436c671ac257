import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { Latest } from "./latest";

describe("the newest of many values", () => {
  beforeEach(() => void vi.useFakeTimers());
  afterEach(() => void vi.useRealTimers());

  it("goes at once, then at most so many times a second, and the last one always", () => {
    const sent: number[] = [];
    const latest = new Latest<number>((value) => sent.push(value), 20);
    for (let n = 0; n < 100; n++) {
      latest.put(n);
      vi.advanceTimersByTime(5);
    }
    vi.advanceTimersByTime(200);
    expect(sent[0]).toBe(0);
    expect(sent.at(-1)).toBe(99);
    expect(sent.length).toBeLessThanOrEqual(12);
    expect(sent.length).toBeGreaterThanOrEqual(10);
  });
});
