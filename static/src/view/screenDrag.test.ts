import * as THREE from "three";
import { expect, test } from "vitest";
import { follow } from "./screenDrag";

const circle = ([angle]: readonly number[]): THREE.Vector2 =>
  new THREE.Vector2(100 * Math.cos((angle! * Math.PI) / 180), 100 * Math.sin((angle! * Math.PI) / 180));
const TURN = [{ low: -720, high: 720, step: 20 }];

test("a turn follows the pointer around, and goes on after a whole turn", () => {
  let values = [0];
  for (let angle = 0; angle <= 450; angle += 15) values = follow(circle, values, TURN, circle([angle]));
  expect(values[0]).toBeCloseTo(450, 1);
});

test("it stays within its range, and comes as near as it may", () => {
  expect(follow(circle, [0], [{ low: -30, high: 30, step: 20 }], circle([80]))[0]).toBeCloseTo(30, 6);
});

test("two values follow together", () => {
  const plane = ([x, z]: readonly number[]): THREE.Vector2 => new THREE.Vector2(90 * x! + 20 * z!, 60 * z!);
  const range = { low: -1, high: 1, step: 0.2 };
  const [x, z] = follow(plane, [0, 0], [range, range], plane([0.6, -0.4]));
  expect(x).toBeCloseTo(0.6, 3);
  expect(z).toBeCloseTo(-0.4, 3);
});

test("a place that no value moves stays", () => {
  expect(follow(() => new THREE.Vector2(5, 5), [3], TURN, new THREE.Vector2(90, 0))).toEqual([3]);
});
