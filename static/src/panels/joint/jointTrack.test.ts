import { expect, test } from "vitest";
import { JointTrack } from "./jointTrack";

test("keeps a joint's turns until another joint or a jump in time", () => {
  const track = new JointTrack();
  track.add("hip", 10, [1, 2, 3]);
  track.add("hip", 10, [1, 2, 3]);
  track.add("hip", 12, [4, 5, 6]);
  expect([track.ticks, track.turns]).toEqual([
    [10, 12],
    [
      [1, 4],
      [2, 5],
      [3, 6],
    ],
  ]);
  track.add("hip", 5, [0, 0, 0]);
  expect(track.ticks).toEqual([5]);
  track.add("knee", 6, [0, 0, 0]);
  expect(track.ticks).toEqual([6]);
});

test("forgets the oldest", () => {
  const track = new JointTrack();
  for (let tick = 0; tick < 700; tick++) track.add("hip", tick, [tick, 0, 0]);
  expect([track.ticks[0], track.turns[0].length]).toEqual([100, 600]);
});
