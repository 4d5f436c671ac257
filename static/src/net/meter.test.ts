import { describe, expect, it } from "vitest";
import { Meter, RoundTrip } from "./meter";

describe("Meter", () => {
  it("counts 60 a second as 60", () => {
    const meter = new Meter();
    for (let i = 0; i < 300; i++) meter.add((i * 1000) / 60, 100);
    expect(meter.perSecond(4990)).toBeCloseTo(60, 0);
    expect(meter.amountPerSecond(4990)).toBeCloseTo(6000, -2);
  });

  it("falls to nothing when nothing comes", () => {
    const meter = new Meter();
    meter.add(0);
    expect(meter.perSecond(5000)).toBe(0);
  });

  it("keeps a bounded memory and an unbounded total", () => {
    const meter = new Meter();
    for (let i = 0; i < 5000; i++) meter.add(i * 16);
    expect(meter.total).toBe(5000);
    expect((meter as unknown as { times: number[] }).times.length).toBeLessThan(1200);
  });
});

describe("RoundTrip", () => {
  it("measures its own questions only", () => {
    const trip = new RoundTrip();
    const ref = trip.ask(10);
    expect([trip.answer("x", 11), trip.answer(ref, 12.5), trip.milliseconds]).toEqual([false, true, 2.5]);
  });
});
