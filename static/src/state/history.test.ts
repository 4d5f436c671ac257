import { describe, expect, it } from "vitest";
import { History } from "./history";

describe("History", () => {
  it("joins equal states to runs", () => {
    const history = new History();
    ["A", "A", "A", "C", "C"].forEach((state, tick) => history.see(1, tick, state));
    expect(history.between(1, 0, 9)).toEqual([
      { start: 0, end: 2, state: "A" },
      { start: 3, end: 4, state: "C" },
    ]);
  });

  it("bridges skipped frames, the older state up to the change", () => {
    const history = new History();
    history.see(1, 0, "D");
    history.see(1, 50, "E");
    expect(history.between(1, 0, 99)).toEqual([
      { start: 0, end: 49, state: "D" },
      { start: 50, end: 50, state: "E" },
    ]);
  });

  it("leaves open what passed while the line was broken", () => {
    const history = new History();
    history.see(1, 4, "D");
    history.markGap();
    [500, 501].forEach((tick) => history.see(1, tick, "D"));
    expect(history.between(1, 0, 999).map((run) => [run.start, run.end])).toEqual([
      [4, 4],
      [500, 501],
    ]);
  });

  it("is not changed by looking back", () => {
    const history = new History();
    history.see(1, 10, "A");
    history.see(1, 3, "F");
    expect([history.stateAt(1, 10), history.stateAt(1, 3)]).toEqual(["A", null]);
  });

  it("finds the state at a tick among many", () => {
    const history = new History();
    for (let tick = 0; tick < 1000; tick++) history.see(1, tick, "ABC"[Math.floor(tick / 10) % 3]!);
    expect([0, 10, 29, 995].map((tick) => history.stateAt(1, tick))).toEqual(["A", "B", "C", "A"]);
  });

  it("keeps actors apart", () => {
    const history = new History();
    history.see(1, 0, "E");
    expect(history.stateAt(2, 0)).toBeNull();
  });

  describe("a verdict", () => {
    const spans = (history: History): (number | string)[][] =>
      history.between(1, 0, 999).map((run) => [run.start, run.end, run.state]);
    const seen = (...frames: [number, string][]): History => {
      const history = new History();
      frames.forEach(([tick, state]) => history.see(1, tick, state));
      return history;
    };

    it("before the frame begins the state", () => {
      const history = seen([0, "A"], [5, "A"]);
      history.enter(1, 7, "B");
      history.see(1, 9, "B");
      expect(spans(history)).toEqual([
        [0, 6, "A"],
        [7, 9, "B"],
      ]);
    });

    it("after the frame moves the beginning to where it was", () => {
      const history = seen([0, "A"], [9, "B"], [12, "B"]);
      history.enter(1, 7, "B");
      expect(spans(history)).toEqual([
        [0, 6, "A"],
        [7, 12, "B"],
      ]);
    });

    it("tells of a state that no frame has shown", () => {
      const history = seen([0, "A"], [9, "C"]);
      history.enter(1, 3, "B");
      history.enter(1, 6, "C");
      expect(spans(history)).toEqual([
        [0, 2, "A"],
        [3, 5, "B"],
        [6, 9, "C"],
      ]);
    });

    it("may tell of two states in one tick: the last one counts", () => {
      const history = seen([0, "A"], [9, "C"]);
      history.enter(1, 4, "B");
      history.enter(1, 4, "C");
      expect(spans(history)).toEqual([
        [0, 3, "A"],
        [4, 9, "C"],
      ]);
    });

    it("that stays in the state changes nothing", () => {
      const history = seen([0, "A"], [9, "A"]);
      history.enter(1, 4, "A");
      expect(spans(history)).toEqual([[0, 9, "A"]]);
    });
  });

  describe("fill", () => {
    const spans = (history: History): (number | string)[][] =>
      history.between(1, 0, 999).map((run) => [run.start, run.end, run.state]);

    it("gives a page that was opened late what came before", () => {
      const history = new History();
      history.see(1, 90, "C");
      history.fill(
        1,
        [
          { tick: 5, state: "A" },
          { tick: 40, state: "B" },
          { tick: 70, state: "C" },
        ],
        80,
      );
      expect(spans(history)).toEqual([
        [5, 39, "A"],
        [40, 69, "B"],
        [70, 90, "C"],
      ]);
    });

    it("leaves alone what was seen since", () => {
      const history = new History();
      history.see(1, 81, "C");
      history.see(1, 90, "D");
      history.fill(1, [{ tick: 0, state: "A" }], 80);
      expect(spans(history)).toEqual([
        [0, 80, "A"],
        [81, 89, "C"],
        [90, 90, "D"],
      ]);
    });

    it("mends what was torn", () => {
      const history = new History();
      history.see(1, 10, "A");
      history.markGap();
      history.see(1, 50, "A");
      history.fill(
        1,
        [
          { tick: 0, state: "A" },
          { tick: 20, state: "B" },
          { tick: 30, state: "A" },
        ],
        50,
      );
      expect(spans(history)).toEqual([
        [0, 19, "A"],
        [20, 29, "B"],
        [30, 50, "A"],
      ]);
    });

    it("passes by a state that lasted no tick", () => {
      const history = new History();
      history.fill(
        1,
        [
          { tick: 0, state: "E" },
          { tick: 0, state: "B" },
        ],
        3,
      );
      expect(spans(history)).toEqual([[0, 3, "B"]]);
    });

    it("goes on from there", () => {
      const history = new History();
      history.fill(1, [{ tick: 0, state: "E" }], 3);
      history.see(1, 9, "E");
      expect(spans(history)).toEqual([[0, 9, "E"]]);
    });
  });
});
