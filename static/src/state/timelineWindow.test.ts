import { describe, expect, it } from "vitest";
import { hello } from "../net/types/examples";
import { Playback } from "./playback";
import { spanOf, TimelineWindow, zoomed } from "./timelineWindow";
import { WatchedStage } from "./watchedStage";

describe("spanOf", () => {
  it.each([
    ["all of it", 0, 600, null, null, null, { from: 0, to: 600 }],
    ["the newest", 0, 9000, 7200, null, null, { from: 1800, to: 9000 }],
    ["an older part", 0, 9000, 1000, 4000, null, { from: 3000, to: 4000 }],
    ["what one looks at, to the left", 0, 9000, 1000, 4000, 100, { from: 100, to: 1100 }],
    ["what one looks at, to the right", 0, 9000, 1000, 4000, 8000, { from: 7000, to: 8000 }],
    ["no part before the first tick", 500, 9000, 1000, 700, null, { from: 500, to: 1500 }],
    ["never nothing", 5, 5, 100, null, null, { from: 5, to: 6 }],
  ])("shows %s", (_, first, head, length, end, looking, expected) =>
    expect(spanOf(first, head, length, end, looking)).toEqual(expected),
  );
});

it("a zoom keeps the tick under the pointer where it is", () => {
  const span = zoomed({ from: 100, to: 500 }, 200, 0.5);
  expect(span).toEqual({ from: 150, to: 350 });
  expect((200 - span.from) / (span.to - span.from)).toBe(0.25);
});

function window(): { timeline: TimelineWindow; playback: Playback; stage: WatchedStage } {
  const stage = new WatchedStage();
  const playback = new Playback(stage, () => true);
  const timeline = new TimelineWindow(stage, playback);
  stage.greet(hello({ first: 0, head: 20_000, tick: 20_000, rate: 60 }));
  return { timeline, playback, stage };
}

describe("TimelineWindow", () => {
  it("goes on with the newest tick until it is moved to the past", () => {
    const { timeline, stage } = window();
    timeline.zoom(0.5, 20_000);
    expect(timeline.span).toEqual({ from: 16_400, to: 20_000 });
    stage.moved(20_100, 20_100);
    expect(timeline.span.to).toBe(20_100);
    timeline.pan(-0.5);
    stage.moved(20_200, 20_200);
    expect(timeline.span).toEqual({ from: 14_700, to: 18_300 });
    timeline.zoom(100);
    expect([timeline.isAll, timeline.span.from]).toEqual([true, 0]);
  });

  it("stands still while the past is shown", () => {
    const { timeline, playback, stage } = window();
    const before = timeline.span;
    playback.look(19_000);
    stage.moved(20_500, 20_500);
    expect(timeline.span).toEqual(before);
    timeline.pan(0.05);
    expect(timeline.span.to).toBe(20_360);
    timeline.pan(0.5);
    expect(timeline.span.to).toBe(20_500);
    playback.live();
    timeline.recent();
    expect(timeline.span.to).toBe(20_500);
  });

  it("makes room for a newer tick that is shown", () => {
    const { timeline, playback, stage } = window();
    timeline.all();
    playback.look(19_000);
    stage.moved(20_500, 20_500);
    expect(timeline.span).toEqual({ from: 0, to: 20_000 });
    playback.look(20_400);
    expect(timeline.span).toEqual({ from: 0, to: 20_400 });
  });

  it("loops what is selected, from its begin, until the page goes live", () => {
    const { timeline, playback } = window();
    timeline.select(700, 600);
    timeline.loop();
    expect([playback.looking.value, playback.replaying.value]).toEqual([600, true]);
    playback.advance(1);
    expect(playback.looking.value).toBe(660);
    playback.advance(1);
    expect(playback.looking.value).toBe(600);
    playback.live();
    expect(playback.loop.value).toBeNull();
  });

  it("marks begin and end at the shown tick, and drops a span of one tick", () => {
    const { timeline, playback } = window();
    playback.look(19_000);
    timeline.mark("from");
    playback.look(19_500);
    timeline.mark("to");
    expect(timeline.selected.value).toEqual({ from: 19_000, to: 19_500 });
    timeline.select(5, 5);
    expect(timeline.selected.value).toBeNull();
  });

  it("marks begin and end of what happens now", () => {
    const { timeline, stage } = window();
    timeline.mark("from");
    const begun = stage.tick;
    stage.moved(begun + 90, begun + 90);
    timeline.mark("to");
    expect(timeline.selected.value).toEqual({ from: begun, to: begun + 90 });
  });
});
