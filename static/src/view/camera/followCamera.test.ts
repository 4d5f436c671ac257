// @vitest-environment happy-dom
import * as THREE from "three";
import { expect, test } from "vitest";
import { FollowCamera } from "./followCamera";
import { framed } from "./framing";
import type { Framing } from "./framingChoice";
import kept from "./shots.json";

const [low, high] = kept.box.map((corner) => new THREE.Vector3().fromArray(corner));
const box = new THREE.Box3(low, high);
const FRAME_S = 1 / 60;

function filmed(framing: Framing, aspect = 1, still = false): FollowCamera {
  const view = new FollowCamera(document.createElement("canvas"), () => still);
  view.resize(1000 * aspect, 1000);
  view.subject(framed(box, framing));
  view.frame();
  return view;
}

const near = (found: readonly number[], wanted: readonly number[], digits = 5): void =>
  found.forEach((number, i) => expect(number).toBeCloseTo(wanted[i]!, digits));

test.each(kept.shots)("films $framing at $aspect as the package does", (shot) => {
  const { camera } = filmed(shot.framing as Framing, shot.aspect);
  near(camera.position.toArray(), shot.position);
  near(camera.getWorldDirection(new THREE.Vector3()).toArray(), shot.sight);
  near([camera.fov, camera.near, camera.far], [shot.field_deg, shot.near, shot.far]);
});

test("what is framed is in the middle of what nothing covers", () => {
  const view = filmed("whole");
  view.resize(1000, 500, 100, 400);
  view.camera.updateMatrixWorld();
  const middle = view.controls.target.clone().project(view.camera);
  near([500 * (middle.x + 1), 250 * (1 - middle.y)], [300, 200], 3);
});

test("follows as the package does", () => {
  const view = filmed("whole", 16 / 9);
  kept.path.forEach((root, tick) => {
    view.aim(new THREE.Vector3().fromArray(root));
    if (tick > 0) view.update(FRAME_S);
    near(view.camera.position.toArray(), kept.places[tick]!);
  });
});

test("a glide ends in the new framing, seen from where the user looked", () => {
  const view = filmed("whole");
  view.standAround([3, 1, 0, 0, 1, 0]);
  view.subject(framed(box, "face"));
  view.glide();
  const before = view.camera.position.clone();
  view.update(FRAME_S);
  expect(view.camera.position.distanceTo(before)).toBeLessThan(0.3);
  for (let frame = 0; frame < 300; frame++) view.update(FRAME_S);
  const wanted = filmed("face");
  near(view.controls.target.toArray(), wanted.controls.target.toArray(), 3);
  const [away, other] = [view, wanted].map(({ camera, controls }) =>
    camera.position.clone().sub(controls.target),
  );
  expect(away!.length()).toBeCloseTo(other!.length(), 3);
  near(away!.normalize().toArray(), [1, 0, 0], 3);
});

test("the user's hand stops a glide; who wants no motion sees a cut", () => {
  const view = filmed("whole");
  view.subject(framed(box, "face"));
  view.glide();
  view.update(FRAME_S);
  view.controls.dispatchEvent({ type: "start" });
  const place = view.camera.position.clone();
  view.update(FRAME_S);
  expect(view.camera.position.distanceTo(place)).toBeLessThan(1e-9);

  const still = filmed("whole", 1, true);
  still.subject(framed(box, "face"));
  still.glide();
  still.update(FRAME_S);
  near(still.camera.position.toArray(), filmed("face").camera.position.toArray());
});

test.each([12, 30, 144])("a drag swings as far at %d drawings a second as at 60", (fps) => {
  const azimuth = (drawings: number): number => {
    const view = filmed("whole");
    // What a drag leaves to the next drawings, radians.
    Object.assign(view.controls, { _sphericalDelta: new THREE.Spherical(1, 0, 0.5) });
    for (let drawing = 0; drawing < drawings / 3; drawing++) view.update(1 / drawings);
    return view.controls.getAzimuthalAngle();
  };
  expect(azimuth(fps)).toBeCloseTo(azimuth(60), 5);
});
