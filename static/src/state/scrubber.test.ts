import { describe, expect, it } from "vitest";
import { Scrubber } from "./scrubber";

function asking(): { back: Scrubber; asked: (number | string)[] } {
  const asked: (number | string)[] = [];
  const back = new Scrubber(
    (message) => asked.push(message.type === "look" ? message.tick : message.type) > 0,
  );
  return { back, asked };
}

describe("Scrubber", () => {
  it("asks one tick at a time, and only for the newest wish after it", () => {
    const { back, asked } = asking();
    [10, 20, 30].forEach((tick) => back.look(tick));
    back.arrived(10);
    back.arrived(30);
    expect(asked).toEqual([10, 30]);
  });

  it("is not woken by frames it did not ask for", () => {
    const { back, asked } = asking();
    back.look(10);
    back.look(20);
    back.arrived(99);
    expect(asked).toEqual([10]);
  });

  it("goes back to live", () => {
    const { back, asked } = asking();
    back.look(10);
    back.live();
    expect([back.looking.value, asked]).toEqual([null, [10, "live"]]);
  });

  it("is not stuck when a tick is refused", () => {
    const { back, asked } = asking();
    back.look(10);
    back.refused();
    back.look(20);
    expect(asked).toEqual([10, 20]);
  });

  it("asks again after a reconnection", () => {
    const { back, asked } = asking();
    back.look(10);
    back.again();
    expect(asked).toEqual([10, 10]);
  });
});
