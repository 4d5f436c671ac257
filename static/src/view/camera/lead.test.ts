// @vitest-environment happy-dom
import * as THREE from "three";
import { expect, test } from "vitest";
import { FollowCamera } from "./followCamera";

const FRAME_S = 1 / 60;
const PLACE = [3, 1, 0, 0, 1, 0];

function filmed(still = false): FollowCamera {
  const view = new FollowCamera(document.createElement("canvas"), () => still);
  view.resize(100, 100);
  view.subject(new THREE.Box3(new THREE.Vector3(-0.5, 0, -0.5), new THREE.Vector3(0.5, 1.8, 0.5)));
  view.frame();
  view.standAround([1, 1, 0, 0, 1, 0]);
  return view;
}

const distances = (view: FollowCamera, frames: number): number[] =>
  Array.from({ length: frames }, () => {
    view.update(FRAME_S);
    return view.around[0]!;
  });

test("another page's camera is reached evenly, and while the character goes on", () => {
  const view = filmed();
  view.lead(PLACE);
  view.aim(new THREE.Vector3(0, 0, 0.3));
  const places = [1, ...distances(view, 8)];
  const steps = places.slice(1).map((metres, k) => metres - places[k]!);
  for (const step of steps) expect(step).toBeCloseTo(steps[0]!, 4);
  distances(view, 60);
  view.around.forEach((metres, k) => expect(metres).toBeCloseTo(PLACE[k]!, 4));
});

test("who wants no motion sees a cut", () => {
  const view = filmed(true);
  view.lead(PLACE);
  view.update(FRAME_S);
  view.around.forEach((metres, k) => expect(metres).toBeCloseTo(PLACE[k]!, 6));
});
