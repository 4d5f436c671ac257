import { describe, expect, it } from "vitest";
import { type Delivery, Relay, tickOfMessage } from "./relay";

function frame(tick: number): ArrayBuffer {
  return new Uint32Array([0x31575453, 1, tick, tick, 0, 0, 0, 32]).buffer;
}

function relaying(): { relay: Relay; acked: number[]; delivery: Delivery[] } {
  const [acked, delivery]: [number[], Delivery[]] = [[], []];
  return {
    relay: new Relay(
      (tick) => acked.push(tick),
      (one) => delivery.push(one),
    ),
    acked,
    delivery,
  };
}

describe("Relay", () => {
  it("acknowledges every frame with its tick, whatever the page does", () => {
    const { relay, acked } = relaying();
    for (let tick = 1; tick <= 9; tick++) relay.receive(frame(tick));
    expect(acked).toEqual([1, 2, 3, 4, 5, 6, 7, 8, 9]);
  });

  it("hands a busy page the newest frame when it is back, and says what it passed over", () => {
    const { relay, delivery } = relaying();
    for (let tick = 1; tick <= 9; tick++) relay.receive(frame(tick));
    relay.taken();
    expect(delivery.map(({ frame: buffer }) => tickOfMessage(buffer))).toEqual([1, 2, 3, 4, 9]);
    expect(delivery[4]).toMatchObject({ skipped: 4, skippedBytes: 128 });
  });

  it("hands on every frame to a page that keeps up", () => {
    const { relay, delivery } = relaying();
    for (let tick = 1; tick <= 9; tick++) {
      relay.receive(frame(tick));
      relay.taken();
    }
    expect(delivery.map(({ skipped }) => skipped)).toEqual(Array(9).fill(0));
  });

  it("has no tick for what is no frame", () => expect(tickOfMessage(new ArrayBuffer(3))).toBeNull());
});
