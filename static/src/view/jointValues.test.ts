import * as THREE from "three";
import { expect, test } from "vitest";
import type { JointLimit } from "../net/protocol";
import { freedomValues, valueWords } from "./jointValues";

const REST = new THREE.Quaternion().setFromEuler(new THREE.Euler(0.3, -0.8, 0.5));
const FRAME = new THREE.Quaternion().setFromUnitVectors(
  new THREE.Vector3(0, 1, 0),
  new THREE.Vector3(1, 2, -1).normalize(),
);

function limit(type: string, symbol: string, names: string[], pitch = 0): JointLimit {
  return {
    joint: "B",
    type,
    form: "",
    symbol,
    shape: "free",
    frame: FRAME.toArray(),
    rest: [0.1, 0.2, 0.3, ...REST.toArray()],
    pitch,
    freedoms: names.map((name) => ({
      name,
      is_angle: !/^(slide|translate)/.test(name),
      minimum: null,
      maximum: null,
    })),
  };
}

/** A joint that has gone `way` and turned by `turn` from its rest pose, in its frame. */
function moved(way: THREE.Vector3, turn: THREE.Quaternion): THREE.Object3D {
  const joint = new THREE.Object3D();
  joint.quaternion.copy(REST).multiply(FRAME).multiply(turn).multiply(FRAME.clone().invert());
  joint.position
    .copy(way)
    .applyQuaternion(FRAME)
    .applyQuaternion(REST)
    .add(new THREE.Vector3(0.1, 0.2, 0.3));
  return joint;
}

const Y = new THREE.Vector3(0, 1, 0);
const about = (axis: THREE.Vector3, degrees: number): THREE.Quaternion =>
  new THREE.Quaternion().setFromAxisAngle(axis, (degrees * Math.PI) / 180);

test("an angle and a slide", () => {
  const values = freedomValues(
    limit("cylindrical", "RP", ["angle", "slide"]),
    moved(new THREE.Vector3(0, 0.25, 0), about(Y, -130)),
  );
  expect(values.get("angle")).toBeCloseTo(-130, 6);
  expect(values.get("slide")).toBeCloseTo(0.25, 6);
});

test("a screw tells its whole turns by its way", () => {
  const values = freedomValues(
    limit("helical", "H", ["angle"], 0.2),
    moved(new THREE.Vector3(0, 0.5, 0), about(Y, 900)),
  );
  expect(values.get("angle")).toBeCloseTo(900, 4);
});

test("a sphere twists first and swings then", () => {
  const swing = about(new THREE.Vector3(3, 0, -4).normalize(), 50);
  const values = freedomValues(
    limit("spherical", "3R", ["swing_x", "swing_z", "twist"]),
    moved(new THREE.Vector3(), swing.multiply(about(Y, 70))),
  );
  expect(values.get("swing_x")).toBeCloseTo(30, 4);
  expect(values.get("swing_z")).toBeCloseTo(-40, 4);
  expect(values.get("twist")).toBeCloseTo(70, 4);
});

test.each([
  ["PPR", [1, 2]],
  ["PRP", [1 + 2 * Math.sin(0.5), 2 * Math.cos(0.5)]],
  ["RPP", [Math.cos(0.5) + 2 * Math.sin(0.5), 2 * Math.cos(0.5) - Math.sin(0.5)]],
])("slides of a plane in the order %s", (order, [x, z]) => {
  const values = freedomValues(
    limit("planar", order, ["slide_x", "slide_z", "angle"]),
    moved(new THREE.Vector3(x, 0, z), about(Y, (0.5 * 180) / Math.PI)),
  );
  expect(values.get("slide_x")).toBeCloseTo(1, 5);
  expect(values.get("slide_z")).toBeCloseTo(2, 5);
});

test("angles about X, then Y, then Z", () => {
  const turn = about(new THREE.Vector3(0, 0, 1), 30)
    .multiply(about(Y, 20))
    .multiply(about(new THREE.Vector3(1, 0, 0), 10));
  const values = freedomValues(
    limit("", "", ["rotate_x", "rotate_y", "rotate_z"]),
    moved(new THREE.Vector3(), turn),
  );
  expect([...values.values()].map((value) => Math.round(value * 1000) / 1000)).toEqual([10, 20, 30]);
});

test("words", () => {
  expect([valueWords(34.25, true), valueWords(0.12, false)]).toEqual(["34.3°", "0.120 m"]);
});
