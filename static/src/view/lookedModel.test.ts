import * as THREE from "three";
import { expect, it } from "vitest";
import { LookedModel } from "./lookedModel";
import type { Model } from "./model";

const lift = (name: string, to: number): THREE.AnimationClip =>
  new THREE.AnimationClip(name, 1, [
    new THREE.VectorKeyframeTrack("hand.position", [0, 1], [0, 0, 0, 0, to, 0]),
  ]);

/** A hand that holds a sword, two clips that lift the hand, and the target `smile` of the hand. */
function looked(): { model: LookedModel; hand: THREE.Mesh; sword: THREE.Mesh } {
  const [hand, sword, scene] = [new THREE.Mesh(), new THREE.Mesh(), new THREE.Group()];
  hand.name = "hand";
  Object.assign(hand, { morphTargetDictionary: { smile: 0 }, morphTargetInfluences: [0] });
  hand.add(sword);
  scene.add(hand);
  const animations = [lift("low", 2), lift("high", 4)];
  const model = { scene, animations, nodes: [hand, sword] } as unknown as Model;
  return { model: new LookedModel(model), hand, sword };
}

it("plays one clip alone, at the chosen speed", () => {
  const { model, hand } = looked();
  model.toggle(0);
  model.toggle(1);
  model.speed.value = 0.5;
  model.advance(0.5);
  expect([[...model.playing.value], hand.position.y]).toEqual([[1], 1]);
});

it("mixes clips without solo", () => {
  const { model, hand } = looked();
  model.solo.value = false;
  model.toggle(0);
  model.toggle(1);
  model.advance(0.5);
  expect(hand.position.y).toBe((1 + 2) / 2);
});

it("stays at the end without loop, and begins again with it", () => {
  const { model, hand } = looked();
  model.toggle(0);
  model.advance(1.25);
  const looping = hand.position.y;
  model.setLoop(false);
  model.advance(1.25);
  expect([looping, hand.position.y]).toEqual([0.5, 2]);
});

it("stands at rest when its last clip ends", () => {
  const { model, hand } = looked();
  model.toggle(0);
  model.advance(0.5);
  model.toggle(0);
  expect([hand.position.y, model.advance(0.5)]).toEqual([0, false]);
});

it("shows the moment that is sought", () => {
  const { model, hand } = looked();
  model.toggle(1);
  model.seek(0.75);
  expect([hand.position.y, model.time.value, model.advance(1)]).toEqual([3, 0.75, false]);
});

it("hides a mesh, and not what hangs below it", () => {
  const { model, hand, sword } = looked();
  model.hide(model.meshes[0]!, true);
  const camera = new THREE.Camera();
  expect([hand, sword].map(({ layers }) => layers.test(camera.layers))).toEqual([false, true]);
});

it("keeps a weight that was set while a clip plays", () => {
  const { model, hand } = looked();
  model.toggle(0);
  model.setWeight("smile", 0.5);
  model.advance(0.1);
  expect(hand.morphTargetInfluences).toEqual([0.5]);
});

it("draws a skin where its bones are, whatever the transform of its node", () => {
  const [skin, scene] = [new THREE.SkinnedMesh(new THREE.BoxGeometry()), new THREE.Group()];
  scene.scale.setScalar(100);
  scene.add(skin);
  new LookedModel({ scene, animations: [], nodes: [skin] } as unknown as Model);
  new THREE.Scene().add(scene).updateMatrixWorld();
  const beforeDrawing = skin.onBeforeRender.bind(skin) as unknown as () => void;
  beforeDrawing();
  expect(skin.matrixWorld).toEqual(new THREE.Matrix4());
});

it("tells each mesh by its place in the file: meshes of one node come after each other", () => {
  const [scene, body, lid, skin, buckle] = [0, 0, 0, 0, 0].map(() => new THREE.Group());
  const meshes = [1, 2, 3].map(() => new THREE.Mesh());
  body!.add(meshes[0]!, meshes[1]!, lid!);
  lid!.add(meshes[2]!);
  skin!.add(buckle!);
  scene!.add(body!, skin!);
  const nodes = [skin, body, meshes[2]];
  const { meshes: looked } = new LookedModel({ scene, animations: [], nodes } as unknown as Model);
  expect(looked.map(({ place }) => place)).toEqual(["1/0", "1/1", "2/0"]);
});
