/** Balls in the scene that you drag: each is the value of a point or a direction of the watched machine. */

import * as THREE from "three";
import type { Point } from "../state/points";
import { drawnDiscs, handleAt } from "./handlePick";
import type { Scene } from "./scene";

/** The place where a ray meets the plane through `through` that faces the camera; null: it does not meet it. */
export function onFacingPlane(
  ray: THREE.Ray,
  camera: THREE.Camera,
  through: THREE.Vector3,
): THREE.Vector3 | null {
  const normal = camera.getWorldDirection(new THREE.Vector3());
  return ray.intersectPlane(
    new THREE.Plane().setFromNormalAndCoplanarPoint(normal, through),
    new THREE.Vector3(),
  );
}

export class PointHandles {
  private readonly balls = new Map<string, THREE.Mesh>();
  /** From where the directions begin to their balls. */
  private readonly lines = new Map<string, THREE.Line>();
  private readonly shape = new THREE.SphereGeometry(1, 24, 16);
  private readonly look = new THREE.MeshBasicMaterial({
    color: "#e9803a",
    transparent: true,
    opacity: 0.75,
    depthTest: false,
  });
  private readonly lineLook = new THREE.LineBasicMaterial({ color: "#e9803a", depthTest: false });
  private readonly caster = new THREE.Raycaster();
  private dragged: string | null = null;

  constructor(
    private readonly scene: Scene,
    private readonly moved: (name: string, point: Point) => void,
    private readonly held: (name: string, isHeld: boolean) => void = () => undefined,
  ) {
    const { canvas } = scene;
    scene.handles.push(this);
    canvas.addEventListener("pointerdown", (event) => this.grab(event), { capture: true });
    canvas.addEventListener("pointermove", (event) => this.drag(event));
    for (const end of ["pointerup", "pointercancel"] as const)
      canvas.addEventListener(end, () => this.drop());
  }

  /** Shows a handle of `size` metres at a point; of a direction: with a line to it from where it begins. */
  show(name: string, point: Point, size: number, from: Point | null = null): void {
    let ball = this.balls.get(name);
    if (!ball) {
      ball = new THREE.Mesh(this.shape, this.look);
      ball.renderOrder = 20;
      this.balls.set(name, ball);
      this.scene.world.add(ball);
    }
    ball.position.set(...point);
    ball.scale.setScalar(size);
    if (from) this.line(name).setFromPoints([new THREE.Vector3(...from), ball.position]);
    this.scene.invalidate();
  }

  /** The handle that is dragged; null: none. */
  get dragging(): string | null {
    return this.dragged;
  }

  hide(name: string): void {
    this.balls.get(name)?.removeFromParent();
    this.balls.delete(name);
    this.lines.get(name)?.removeFromParent();
    this.lines.get(name)?.geometry.dispose();
    this.lines.delete(name);
    this.scene.invalidate();
  }

  clear(): void {
    for (const name of [...this.balls.keys()]) this.hide(name);
    this.drop();
  }

  /** Where each handle is drawn, in pixels of the page; for tests. */
  places(): Record<string, [number, number]> {
    return Object.fromEntries([...this.discs()].map(([name, { x, y }]) => [name, [x, y]]));
  }

  /** The ray under the pointer. */
  ray(event: PointerEvent): THREE.Ray {
    const box = this.scene.canvas.getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width) * 2 - 1;
    const y = 1 - ((event.clientY - box.top) / box.height) * 2;
    this.caster.setFromCamera(new THREE.Vector2(x, y), this.scene.view.camera);
    return this.caster.ray;
  }

  private line(name: string): THREE.BufferGeometry {
    let line = this.lines.get(name);
    if (!line) {
      line = new THREE.Line(new THREE.BufferGeometry(), this.lineLook);
      line.renderOrder = 20;
      line.frustumCulled = false;
      this.lines.set(name, line);
      this.scene.world.add(line);
    }
    return line.geometry;
  }

  private discs(): ReturnType<typeof drawnDiscs> {
    return drawnDiscs(this.balls, this.scene.view.camera, this.scene.canvas);
  }

  private grab(event: PointerEvent): void {
    const name = event.button === 0 ? handleAt(this.discs(), event) : null;
    if (name === null) return;
    this.dragged = name;
    this.scene.view.controls.enabled = false;
    this.scene.canvas.setPointerCapture(event.pointerId);
    this.held(name, true);
  }

  private drag(event: PointerEvent): void {
    const ball = this.dragged === null ? undefined : this.balls.get(this.dragged);
    const place = ball && onFacingPlane(this.ray(event), this.scene.view.camera, ball.position);
    if (!ball || !place || this.dragged === null) return;
    ball.position.copy(place);
    this.scene.invalidate();
    this.moved(this.dragged, place.toArray());
  }

  private drop(): void {
    if (this.dragged === null) return;
    this.held(this.dragged, false);
    this.dragged = null;
    this.scene.view.controls.enabled = true;
  }
}
