import { describe, expect, it } from "vitest";
import { History } from "./history";
import type { Verdict } from "./net/protocol";

const verdict = (tick: number, event: string): Verdict => ({
  type: "verdict", tick, actor: 1, layer: 0, event, verdict: "taken", reason: "", from: "A", to: "B",
});

describe("History", () => {
  it("joins equal states to runs", () => {
    const history = new History();
    [0, 0, 0, 2, 2].forEach((state, tick) => history.see(1, tick, state));
    expect(history.between(1, 0, 9)).toEqual([{ start: 0, end: 2, state: 0 }, { start: 3, end: 4, state: 2 }]);
  });

  it("bridges skipped frames, the older state up to the change", () => {
    const history = new History();
    history.see(1, 0, 3);
    history.see(1, 50, 4);
    expect(history.between(1, 0, 99)).toEqual([{ start: 0, end: 49, state: 3 }, { start: 50, end: 50, state: 4 }]);
  });

  it("leaves open what passed while the line was broken", () => {
    const history = new History();
    history.see(1, 4, 3);
    history.tear();
    [500, 501].forEach((tick) => history.see(1, tick, 3));
    expect(history.between(1, 0, 999).map((run) => [run.start, run.end])).toEqual([[4, 4], [500, 501]]);
  });

  it("is not changed by looking back", () => {
    const history = new History();
    history.see(1, 10, 0);
    history.see(1, 3, 5);
    expect([history.stateAt(1, 10), history.stateAt(1, 3)]).toEqual([0, null]);
  });

  it("finds the state at a tick among many", () => {
    const history = new History();
    for (let tick = 0; tick < 1000; tick++) history.see(1, tick, Math.floor(tick / 10) % 3);
    expect([0, 10, 29, 995].map((tick) => history.stateAt(1, tick))).toEqual([0, 1, 2, 0]);
  });

  it("keeps actors apart", () => {
    const history = new History();
    history.see(1, 0, 4);
    expect(history.stateAt(2, 0)).toBeNull();
  });

  it("marks events but not the end of a motion", () => {
    const history = new History();
    history.judge(verdict(5, "JUMP"));
    history.judge(verdict(6, "END"));
    expect(history.marksBetween(1, 0, 9).map((mark) => mark.name)).toEqual(["JUMP"]);
  });

  it("takes what came before from the log, inputs only", () => {
    const history = new History();
    const entry = (tick: number, kind: string) => ({ tick, kind, actor: 1, name: "GO" });
    history.remember([entry(1, "add"), entry(2, "press"), entry(3, "release"), entry(9, "press")], 5);
    expect(history.marksBetween(1, 0, 99)).toEqual([{ tick: 2, actor: 1, name: "GO", kind: "logged" }]);
  });

  describe("fill", () => {
    const spans = (history: History): number[][] => history.between(1, 0, 999).map((run) => [run.start, run.end, run.state]);

    it("gives a page that was opened late what came before", () => {
      const history = new History();
      history.see(1, 90, 2);
      history.fill(1, [{ tick: 5, state: 0 }, { tick: 40, state: 1 }, { tick: 70, state: 2 }], 80);
      expect(spans(history)).toEqual([[5, 39, 0], [40, 69, 1], [70, 90, 2]]);
    });

    it("leaves alone what was seen since", () => {
      const history = new History();
      [[81, 2], [90, 3]].forEach(([tick, state]) => history.see(1, tick!, state!));
      history.fill(1, [{ tick: 0, state: 0 }], 80);
      expect(spans(history)).toEqual([[0, 80, 0], [81, 89, 2], [90, 90, 3]]);
    });

    it("mends what was torn", () => {
      const history = new History();
      history.see(1, 10, 0);
      history.tear();
      history.see(1, 50, 0);
      history.fill(1, [{ tick: 0, state: 0 }, { tick: 20, state: 1 }, { tick: 30, state: 0 }], 50);
      expect(spans(history)).toEqual([[0, 19, 0], [20, 29, 1], [30, 50, 0]]);
    });

    it("passes by a state that lasted no tick", () => {
      const history = new History();
      history.fill(1, [{ tick: 0, state: 4 }, { tick: 0, state: 1 }], 3);
      expect(spans(history)).toEqual([[0, 3, 1]]);
    });

    it("goes on from there", () => {
      const history = new History();
      history.fill(1, [{ tick: 0, state: 4 }], 3);
      history.see(1, 9, 4);
      expect(spans(history)).toEqual([[0, 9, 4]]);
    });
  });
});
