/**
 * `window.__viewer`: the page's state for tests in a real browser. Reading it changes nothing.
 *
 * ready        the watched actor is drawn and its machine is known (keys need the machine)
 * stage() tick() head() hash() state() looking() link() frames() quality()
 *              as shown now; state() is a name, looking() is null while live
 * posed() shown()
 *              tick and stream ("pose", "glb") of the frame that is drawn
 * layerStates() version() played()
 *              the state of each layer; the version of the table; the version that the stage plays,
 *              in the stage's own count
 * viewers()    number of pages at this stage
 * overlays()   number of actors whose bones are drawn
 * lanes()      [first tick, last tick, state] of every known run of the watched actor's base layer
 * stats()      { received, drawn: totals; hz, fps, kBps, latencyMs: over the last two seconds }
 * joints()     { name: [x, y, z] } world positions of the watched actor's joints, metres
 * weights()    { name: weight } of the morph targets of the characters, of the first actor of each cast
 * bodies()     number of meshes, lines and points that draw the characters
 * calls()      number of draw calls of the last drawing
 * held()       { geometries, textures } that the GPU holds, { objects } in the world
 * places()     { id: [x, y] } where the middle of each actor is drawn, pixels
 * world()      { joint: 16 numbers } world matrices of the joints of an actor, column by column
 * detail()     { level: the watched actor's, 0 the full skin; levels: of its model, [{steps, error_m}];
 *              triangles: in the last drawing }
 * proved()     { difference: metres or why there is none; actor, tick, way: what was compared for it }
 * handles()    { name: [x, y] } where the handles of point parameters, and of joints, are drawn, pixels
 * joint()      the joint that was clicked, or ""
 * circle(name) [x, y] where the circle of a joint is drawn, pixels
 * pixels()     draws the characters alone: { covered: share of the picture 0…1,
 *              box: [left, top, right, bottom] 0…1, colour: mean [r, g, b] 0…255 of what is covered }
 * camera()     { position, target }, metres
 * around()     both, six numbers, from the root that the camera follows, metres
 * ghost()      the tick at which the ghost is drawn; -1: there is none
 * listen(s)    counts messages for s seconds: { perSecond, gapP99Ms, ticks: number of distinct ticks }
 */

import * as THREE from "three";
import { laneKey } from "./state/history";
import type { State } from "./state/state";
import type { App } from "./view/app";
import { drawAlone } from "./view/bodiesAlone";
import type { CrowdMesh } from "./view/crowdMesh";
import { PoseTexture } from "./view/poseTexture";
import type { StageView } from "./view/stageView";

const [WIDTH, HEIGHT] = [320, 240];

interface Pixels {
  covered: number;
  box: [number, number, number, number];
  colour: [number, number, number];
}

const millimetres = (places: readonly number[]): number[] =>
  places.map((metres) => Math.round(1000 * metres) / 1000);

function cameraOf({ scene: { view } }: StageView): Record<string, number[]> {
  return {
    position: millimetres(view.camera.position.toArray()),
    target: millimetres(view.controls.target.toArray()),
  };
}

/** Draws the characters alone; returns RGBA rows, bottom row first. */
function drawBodies(stageView: StageView): Uint8Array {
  const { renderer, world, view } = stageView.scene;
  const target = new THREE.WebGLRenderTarget(WIDTH, HEIGHT);
  const data = new Uint8Array(WIDTH * HEIGHT * 4);
  drawAlone(renderer, world, view.camera, stageView.bodies(), target);
  renderer.readRenderTargetPixels(target, 0, 0, WIDTH, HEIGHT, data);
  target.dispose();
  stageView.scene.invalidate();
  return data;
}

function measure(data: Uint8Array): Pixels {
  let count = 0;
  const sum: [number, number, number] = [0, 0, 0];
  const box: Pixels["box"] = [1, 1, 0, 0];
  for (let i = 0; i < WIDTH * HEIGHT; i++) {
    if (data[i * 4 + 3]! < 128) continue;
    count++;
    const [x, y] = [(i % WIDTH) / WIDTH, 1 - Math.floor(i / WIDTH) / HEIGHT];
    box.splice(0, 4, Math.min(box[0], x), Math.min(box[1], y), Math.max(box[2], x), Math.max(box[3], y));
    for (const channel of [0, 1, 2] as const) sum[channel] += data[i * 4 + channel]!;
  }
  const mean = sum.map((value) => Math.round(value / Math.max(1, count))) as Pixels["colour"];
  return { covered: count / (WIDTH * HEIGHT), box, colour: mean };
}

function jointsByName(stageView: StageView): Record<string, number[]> {
  const actor = stageView.watched.model;
  if (!actor) return {};
  const world = actor.jointPositions(new Float32Array(actor.cast.joints * 3));
  return Object.fromEntries(actor.cast.names.map((name, j) => [name, [...world.subarray(j * 3, j * 3 + 3)]]));
}

function weightsByName(stageView: StageView): Record<string, number> {
  const weights: Record<string, number> = {};
  for (const body of stageView.meshes()) {
    const { morphTargetDictionary: rows, morphTargetInfluences: values, skeleton } = body as CrowdMesh;
    const pose = skeleton instanceof PoseTexture ? skeleton : null; // influences are places in a pose then
    for (const [name, row] of Object.entries(rows ?? {})) {
      const value = values?.[row] ?? 0;
      weights[name] = pose ? (pose.numbers[4 * pose.start(0) + value] ?? 0) : value;
    }
  }
  return weights;
}

/** Where a place of the stage is drawn, pixels of the page. */
function pixelOf(stageView: StageView, place: THREE.Vector3): [number, number] {
  const { view, canvas } = stageView.scene;
  const box = canvas.getBoundingClientRect();
  const { x, y } = place.project(view.camera);
  return [box.left + ((x + 1) / 2) * box.width, box.top + ((1 - y) / 2) * box.height];
}

function placesOf(stageView: StageView): Record<string, [number, number]> {
  const actors = stageView.everyActor();
  return Object.fromEntries(
    actors.map((actor) => [
      actor.id,
      pixelOf(stageView, actor.box().getCenter(new THREE.Vector3()).add(actor.position)),
    ]),
  );
}

function worldOf(stageView: StageView, id: number): Record<string, number[]> {
  const actor = stageView.everyActor().find((one) => one.id === id);
  const names = actor?.cast.names ?? [];
  return Object.fromEntries(names.map((name, joint) => [name, Array.from(actor!.jointWorld(joint))]));
}

function circleAt(stageView: StageView, name: string): [number, number] {
  return pixelOf(stageView, new THREE.Vector3(...(jointsByName(stageView)[name] ?? [])));
}

/** Counts messages for `seconds`, looking once per animation frame, as the page does. */
async function listen(state: State, seconds: number): Promise<object> {
  const [start, before] = [performance.now(), state.frames.received.total];
  const ticks = new Set<number>();
  const gaps: number[] = [];
  let [last, total] = [start, before];
  while (performance.now() - start < seconds * 1000) {
    await new Promise(requestAnimationFrame);
    const now = performance.now();
    if (state.frames.received.total > total) gaps.push(now - last);
    if (state.frames.received.total > total) [last, total] = [now, state.frames.received.total];
    ticks.add(state.stage.tick);
  }
  gaps.sort((a, b) => a - b);
  const elapsed = (performance.now() - start) / 1000;
  return {
    perSecond: (state.frames.received.total - before) / elapsed,
    gapP99Ms: gaps[Math.floor(gaps.length * 0.99)] ?? null,
    ticks: ticks.size,
  };
}

/** Where each handle is drawn. */
const handlesOf = ({ scene }: StageView): Record<string, [number, number]> =>
  Object.fromEntries(scene.handles.flatMap((handles) => Object.entries(handles.places())));

export function exposeForTests(app: App): void {
  const { view: stageView, ...state } = app;
  const { drawn } = stageView;
  const stats = (): object => {
    const now = performance.now();
    const { received } = state.frames;
    const { trip } = state.session;
    const rates = {
      hz: received.perSecond(now),
      fps: drawn.perSecond(now),
      kBps: received.amountPerSecond(now) / 1000,
      latencyMs: trip.milliseconds,
    };
    return { received: received.total, drawn: drawn.total, ...rates };
  };
  const hook = {
    get ready(): boolean {
      const known = state.machine.isActors;
      return stageView.watched.ready.value && known && state.stage.id === state.stage.hello.value?.stage;
    },
    stage: () => state.stage.id,
    tick: () => state.stage.tick,
    head: () => state.stage.head,
    hash: () => state.stage.hash,
    state: () => state.selection.stateName(state.selection.state.value),
    layerStates: () => state.selection.layerStates.value,
    version: () => state.machine.info.value?.version ?? 0,
    played: () => state.selection.cast?.version ?? 0,
    looking: () => state.playback.looking.value,
    viewers: () => state.stage.status.value.viewers,
    link: () => state.line.link.value.state,
    frames: () => state.frames.kind.value,
    posed: () => stageView.posed,
    shown: () => stageView.stream,
    overlays: () => stageView.overlays,
    bodies: () => stageView.meshes().length,
    detail: () => ({
      level: stageView.watched.shownLevel,
      levels: stageView.watched.cast?.crowd.model.levels ?? [],
      triangles: stageView.scene.renderer.info.render.triangles,
    }),
    calls: () => stageView.scene.calls,
    held: () => ({
      ...stageView.scene.renderer.info.memory,
      objects: stageView.scene.world.children.length,
    }),
    places: () => placesOf(stageView),
    world: (id: number) => worldOf(stageView, id),
    proved: () => ({ difference: stageView.proof.difference.value, ...stageView.proof.measured }),
    quality: () => stageView.scene.quality,
    lanes: () =>
      state.past.runs
        .between(laneKey(state.selection.actor.value ?? -1), 0, Infinity)
        .map(({ start, end, state }) => [start, end, state]),
    stats,
    weights: () => weightsByName(stageView),
    joints: () => jointsByName(stageView),
    handles: () => handlesOf(stageView),
    joint: () => stageView.watched.joint.value,
    circle: (name: string) => circleAt(stageView, name),
    camera: () => cameraOf(stageView),
    around: () => millimetres(stageView.scene.view.around),
    ghost: () => stageView.ghost.posed,
    pixels: () => measure(drawBodies(stageView)),
    listen: (seconds: number) => listen(state, seconds),
  };
  Object.defineProperty(window, "__viewer", { value: hook });
}
