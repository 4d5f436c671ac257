/** Eight arms side by side; each turns as the server's samples of one interpolation say, and its hand leaves
 * the path that it takes. */

import * as THREE from "three";
import type { CurveView } from "../../net/types/api.generated";
import { token } from "../../ui/dom";
import { METHODS } from "./methods";

const WIDTH = 2.15;
const HEIGHT = 2.7;
const NARROW = 600;
const HAND = new THREE.Vector3(0, 1, 0);

function arm(colour: string): THREE.Group {
  const paint = new THREE.MeshStandardMaterial({ color: colour, roughness: 0.6 });
  const group = new THREE.Group();
  const bone = new THREE.Mesh(new THREE.CylinderGeometry(0.045, 0.09, 0.86, 20), paint);
  bone.position.y = 0.43;
  const hand = new THREE.Mesh(new THREE.BoxGeometry(0.3, 0.26, 0.08), paint);
  hand.position.y = 0.96;
  const thumb = new THREE.Mesh(new THREE.BoxGeometry(0.09, 0.16, 0.09), paint);
  thumb.position.set(0.2, 0.88, 0);
  group.add(bone, hand, thumb);
  return group;
}

export class Figures {
  private readonly renderer: THREE.WebGLRenderer;
  private readonly scene = new THREE.Scene();
  private readonly camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.1, 50);
  private readonly arms = METHODS.map(({ colour }) => arm(colour));
  private readonly paths = METHODS.map(
    ({ colour }) =>
      new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: colour })),
  );
  private readonly stands: THREE.Group[] = [];
  private turns: THREE.Quaternion[][] = [];

  /** `hidden`: the names of the curves without an arm. */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly hidden: ReadonlySet<string>,
  ) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.camera.position.set(0, 1.4, 8);
    this.camera.lookAt(0, 0.25, 0);
    const sun = new THREE.DirectionalLight(0xffffff, 2.2);
    sun.position.set(2, 5, 6);
    this.scene.add(sun, new THREE.HemisphereLight(0xffffff, 0x777777, 1.6));
    for (const [at, figure] of this.arms.entries()) {
      const stand = new THREE.Group();
      const foot = new THREE.Mesh(
        new THREE.SphereGeometry(0.12, 24, 16),
        new THREE.MeshStandardMaterial({ color: token("--edge") }),
      );
      stand.add(foot, figure, this.paths[at]!);
      this.stands.push(stand);
      this.scene.add(stand);
    }
    new ResizeObserver(() => this.resize()).observe(canvas);
  }

  /** Takes new samples; a curve that was refused shows no figure. */
  show(curves: readonly CurveView[]): void {
    this.turns = curves.map(({ rotations }) => rotations.map((q) => new THREE.Quaternion(...q)));
    for (const [at, turns] of this.turns.entries()) {
      const points = turns.map((turn) => HAND.clone().applyQuaternion(turn));
      const path = this.paths[at]!;
      path.geometry.dispose();
      path.geometry = new THREE.BufferGeometry().setFromPoints(points);
      this.reveal(at);
    }
  }

  /** Shows the arm of a curve unless the curve is hidden or was refused. */
  reveal(row: number): void {
    const isShown = !this.hidden.has(METHODS[row]!.name) && (this.turns[row] ?? []).length > 0;
    this.paths[row]!.visible = this.arms[row]!.visible = isShown;
  }

  /** Draws all figures at the fraction `part` (0…1) of the time. */
  draw(part: number): void {
    for (const [at, turns] of this.turns.entries()) {
      const place = part * (turns.length - 1);
      const before = turns[Math.floor(place)];
      const after = turns[Math.min(turns.length - 1, Math.floor(place) + 1)];
      if (before && after) this.arms[at]!.quaternion.slerpQuaternions(before, after, place % 1);
    }
    this.renderer.render(this.scene, this.camera);
  }

  private resize(): void {
    const box = this.canvas.getBoundingClientRect();
    this.renderer.setSize(Math.max(1, box.width), Math.max(1, box.height), false);
    const rows = box.width < NARROW ? 2 : 1;
    const columns = Math.ceil(METHODS.length / rows);
    const half = (columns * WIDTH) / 2;
    const high = Math.max(1.45 * rows, (half * box.height) / Math.max(1, box.width));
    const wide = Math.max(half, (high * box.width) / Math.max(1, box.height));
    for (const [at, stand] of this.stands.entries()) {
      stand.position.x = (((at % columns) + 0.5) / columns - 0.5) * 2 * wide;
      stand.position.y = rows === 1 ? 0 : HEIGHT * (0.5 - Math.floor(at / columns));
    }
    this.camera.left = -wide;
    this.camera.right = wide;
    this.camera.top = high;
    this.camera.bottom = -high;
    this.camera.updateProjectionMatrix();
  }
}
