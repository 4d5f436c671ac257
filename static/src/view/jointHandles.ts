/** Balls at the arcs, cones and rails of joints: drag one, and the joint turns or slides within its limits. */

import * as THREE from "three";
import type { JointLimit, Parameter } from "../net/protocol";
import { drawnDiscs, handleAt, metresOfPixel } from "./handlePick";
import type { LimitMark } from "./limitOverlay";
import { markAt } from "./limitShapes";
import type { Scene } from "./scene";
import { follow, type Range } from "./screenDrag";

/** The parameters that one ball moves: one, or the two of a swing or of a plane. */
export interface Handle {
  key: string;
  parameters: readonly Parameter[];
}

/** Returns the handles at a joint. */
export function handlesOf(limit: JointLimit, parameters: readonly Parameter[]): Handle[] {
  const groups = new Map<string, Parameter[]>();
  for (const parameter of parameters) {
    if (parameter.joint !== limit.joint) continue;
    const name = parameter.freedom.replace(/^(swing|slide)_[xz]$/, "$1");
    groups.set(name, [...(groups.get(name) ?? []), parameter]);
  }
  return [...groups].map(([name, moved]) => ({ key: `${limit.joint} ${name}`, parameters: moved }));
}

/** Returns the range in which a handle moves a parameter: its own, and the joint's. */
export function rangeOf(limit: JointLimit, { freedom, minimum, maximum }: Parameter): Range {
  const free = limit.freedoms.find(({ name }) => name === freedom);
  const low = Math.max(minimum, free?.minimum ?? -Infinity);
  const high = Math.min(maximum, free?.maximum ?? Infinity);
  return { low, high: Math.max(low, high), step: free?.is_angle ? 20 : Math.max((high - low) / 8, 1e-6) };
}

interface Shown {
  handle: Handle;
  mark: LimitMark;
  ball: THREE.Mesh;
  values: number[];
}

/** Radius of a ball, in bone lengths, and in pixels at least. */
const [SIZE, PIXELS] = [0.05, 7];

export class JointHandles {
  private readonly shown = new Map<string, Shown>();
  private readonly shape = new THREE.SphereGeometry(1, 20, 14);
  private readonly look = new THREE.MeshBasicMaterial({
    color: "#2f86eb",
    depthTest: false,
    transparent: true,
  });
  private dragged: Shown | null = null;

  constructor(
    private readonly scene: Scene,
    private readonly taken: (handle: Handle) => void,
    private readonly moved: (handle: Handle, values: readonly number[]) => void,
  ) {
    const { canvas } = scene;
    scene.handles.push(this);
    canvas.addEventListener("pointerdown", (event) => this.grab(event), { capture: true });
    canvas.addEventListener("pointermove", (event) => this.drag(event));
    for (const end of ["pointerup", "pointercancel"] as const)
      canvas.addEventListener(end, () => this.drop());
  }

  /** Whether a ball is dragged. */
  get busy(): boolean {
    return this.dragged !== null;
  }

  /** Whether no handles are shown. */
  get isEmpty(): boolean {
    return !this.shown.size;
  }

  /** Shows these handles with the values of their parameters, and no others. */
  show(wanted: readonly { handle: Handle; mark: LimitMark; values: number[] }[]): void {
    const keys = new Set(wanted.map(({ handle }) => handle.key));
    for (const [key, { ball }] of this.shown)
      if (!keys.has(key)) {
        ball.removeFromParent();
        this.shown.delete(key);
        if (this.dragged?.handle.key === key) this.drop();
      }
    for (const { handle, mark, values } of wanted) {
      const ball = this.shown.get(handle.key)?.ball ?? this.ball();
      const held = this.dragged?.handle.key === handle.key ? this.dragged.values : values;
      const shown = { handle, mark, ball, values: held };
      this.shown.set(handle.key, shown);
      if (this.dragged?.handle.key === handle.key) this.dragged = shown;
      ball.position.copy(this.place(shown, held));
      const pixel = metresOfPixel(this.scene.view.camera, this.scene.canvas.clientHeight, ball.position);
      ball.scale.setScalar(Math.max(SIZE * mark.metres, PIXELS * pixel));
    }
  }

  /** Where each handle is drawn, in pixels of the page. */
  places(): Record<string, [number, number]> {
    return Object.fromEntries([...this.discs()].map(([key, { x, y }]) => [key, [x, y]]));
  }

  /** The key of the handle that is dragged; null: none. */
  heldKey(): string | null {
    return this.dragged?.handle.key ?? null;
  }

  /** The degrees of freedom that it moves, in words. */
  heldFreedoms(): string[] {
    return (this.dragged?.handle.parameters ?? []).map(({ freedom }) => freedom.replace("_", " "));
  }

  /** The values of the parameters of the handle that is dragged. */
  held(): ReadonlyMap<string, number> {
    const { handle, values } = this.dragged ?? {};
    return new Map(handle?.parameters.map(({ name }, k) => [name, values![k]!]));
  }

  private discs(): ReturnType<typeof drawnDiscs> {
    const balls = [...this.shown].map(([key, { ball }]) => [key, ball] as const);
    return drawnDiscs(balls, this.scene.view.camera, this.scene.canvas);
  }

  private ball(): THREE.Mesh {
    const ball = new THREE.Mesh(this.shape, this.look);
    ball.renderOrder = 20;
    this.scene.world.add(ball);
    return ball;
  }

  private place({ handle, mark }: Shown, values: readonly number[]): THREE.Vector3 {
    const named = new Map(handle.parameters.map(({ freedom }, k) => [freedom, values[k]!]));
    return markAt(mark.limit, named, mark.bone, mark.metres).applyMatrix4(mark.frame);
  }

  private pixels(shown: Shown, values: readonly number[]): THREE.Vector2 {
    const { clientWidth, clientHeight } = this.scene.canvas;
    const { x, y } = this.place(shown, values).project(this.scene.view.camera);
    return new THREE.Vector2(((x + 1) / 2) * clientWidth, ((1 - y) / 2) * clientHeight);
  }

  private pointer(event: PointerEvent): THREE.Vector2 {
    const box = this.scene.canvas.getBoundingClientRect();
    return new THREE.Vector2(event.clientX - box.left, event.clientY - box.top);
  }

  private grab(event: PointerEvent): void {
    if (event.button !== 0 || this.isEmpty) return;
    const found = this.shown.get(handleAt(this.discs(), event) ?? "");
    if (!found) return;
    this.dragged = found;
    this.scene.view.controls.enabled = false;
    this.scene.canvas.setPointerCapture(event.pointerId);
    this.taken(found.handle);
  }

  private drag(event: PointerEvent): void {
    const { dragged } = this;
    if (!dragged) return;
    const ranges = dragged.handle.parameters.map((parameter) => rangeOf(dragged.mark.limit, parameter));
    dragged.values = follow(
      (values) => this.pixels(dragged, values),
      dragged.values,
      ranges,
      this.pointer(event),
    );
    dragged.ball.position.copy(this.place(dragged, dragged.values));
    this.scene.invalidate();
    this.moved(dragged.handle, dragged.values);
  }

  private drop(): void {
    if (!this.dragged) return;
    this.dragged = null;
    this.scene.view.controls.enabled = true;
  }
}
