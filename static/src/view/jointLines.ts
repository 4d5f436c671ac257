/** Draws the joints of a model that moves by itself: a line from each to the joint above it. */

import * as THREE from "three";

/** Drawn over the skin. */
const ORDER = 10;

type Pair = readonly [above: THREE.Object3D, joint: THREE.Object3D];

/** Returns each joint with the joint above it; without a skin every node is a joint. */
function pairs(nodes: readonly THREE.Object3D[], joints: ReadonlySet<number>): Pair[] {
  const all = new Set(joints.size ? nodes.filter((_, node) => joints.has(node)) : nodes);
  return [...all].flatMap((joint): Pair[] => {
    const { parent } = joint;
    return parent && all.has(parent) ? [[parent, joint]] : [];
  });
}

export class JointLines {
  readonly lines: THREE.LineSegments<THREE.BufferGeometry, THREE.LineBasicMaterial>;
  private readonly pairs: readonly Pair[];

  constructor(nodes: readonly THREE.Object3D[], joints: ReadonlySet<number>, colour: string) {
    this.pairs = pairs(nodes, joints);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(6 * this.pairs.length), 3));
    const material = new THREE.LineBasicMaterial({ color: colour, depthTest: false, transparent: true });
    this.lines = new THREE.LineSegments(geometry, material);
    this.lines.renderOrder = ORDER;
    this.lines.frustumCulled = false;
  }

  /** Moves the lines to the joints, whose world matrices are up to date. */
  follow(): void {
    const places = this.lines.geometry.getAttribute("position") as THREE.BufferAttribute;
    const at = new THREE.Vector3();
    this.pairs.flat().forEach((node, end) => {
      at.setFromMatrixPosition(node.matrixWorld);
      places.setXYZ(end, at.x, at.y, at.z);
    });
    places.needsUpdate = true;
  }
}
