/** Draws bones over the skin: lines with circles (RD1), or tetrahedra, shaded and in wire (RD2). */

import * as THREE from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import type { PosedModel } from "./posedModel";
import { type BoneEnd, boneEnds } from "./boneEnds";
import { type BonePlan, planBones } from "./bones";
import { place, tetrahedronGeometry } from "./tetrahedron";

const CIRCLE_VERTEX = /* glsl */ `
  uniform float pixels;
  void main() {
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    gl_PointSize = pixels;
  }`;

const CIRCLE_FRAGMENT = /* glsl */ `
  uniform vec3 ink;
  uniform vec3 paper;
  uniform float pixels;
  void main() {
    float away = length(gl_PointCoord - 0.5) * pixels;
    float edge = pixels * 0.5 - 1.0;
    float inside = 1.0 - smoothstep(edge - 0.5, edge + 0.5, away);
    float ring = smoothstep(edge - 2.4, edge - 1.4, away);
    if (inside < 0.01) discard;
    gl_FragColor = vec4(mix(paper, ink, ring), inside);
    #include <colorspace_fragment>
  }`;

/** A point is a square that faces the camera, and so does its circle. */
export function circleMaterial(pixelRatio: number): THREE.ShaderMaterial {
  const uniforms = {
    ink: { value: new THREE.Color() },
    paper: { value: new THREE.Color() },
    pixels: { value: 10 * pixelRatio },
  };
  return new THREE.ShaderMaterial({
    vertexShader: CIRCLE_VERTEX,
    fragmentShader: CIRCLE_FRAGMENT,
    uniforms,
    transparent: true,
    depthTest: false,
    depthWrite: false,
  });
}

export class BoneOverlay {
  readonly object = new THREE.Group();
  private readonly lines = new THREE.Group();
  private readonly solids = new THREE.Group();
  private readonly plan: BonePlan;
  private readonly last: BoneEnd[];
  private readonly world: Float32Array;
  /** World positions of each bone's start and end, metres. */
  private readonly bones: Float32Array;
  private readonly ends: THREE.InstancedInterleavedBuffer;
  private readonly circles: THREE.BufferAttribute;
  private readonly shaded: THREE.InstancedMesh;
  private readonly wire: THREE.InstancedMesh;
  private readonly lineMaterial = new LineMaterial({
    linewidth: 2.5,
    depthTest: false,
    depthWrite: false,
    transparent: true,
  });
  private readonly circleMaterial: THREE.ShaderMaterial;
  private readonly solidMaterial = new THREE.MeshLambertMaterial({
    flatShading: true,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
  private readonly wireMaterial = new THREE.MeshBasicMaterial({ wireframe: true });

  constructor(
    private readonly actor: PosedModel,
    pixelRatio: number,
  ) {
    this.plan = planBones(actor.cast, actor.model.skinJoints);
    this.last = boneEnds(this.plan, actor.cast, actor.model);
    const count = this.plan.segments.length + this.last.length;
    this.world = new Float32Array(actor.cast.joints * 3);
    this.bones = new Float32Array(count * 6);
    const geometry = new LineSegmentsGeometry().setPositions(new Float32Array(Math.max(1, count) * 6));
    this.ends = (geometry.attributes["instanceStart"] as THREE.InterleavedBufferAttribute)
      .data as THREE.InstancedInterleavedBuffer;
    const points = new THREE.BufferGeometry();
    this.circles = new THREE.BufferAttribute(new Float32Array(this.plan.joints.length * 3), 3);
    points.setAttribute("position", this.circles);
    this.circleMaterial = circleMaterial(pixelRatio);
    this.lines.add(
      new LineSegments2(geometry, this.lineMaterial),
      new THREE.Points(points, this.circleMaterial),
    );
    this.shaded = new THREE.InstancedMesh(tetrahedronGeometry(), this.solidMaterial, count);
    this.wire = new THREE.InstancedMesh(this.shaded.geometry, this.wireMaterial, count);
    this.wire.instanceMatrix = this.shaded.instanceMatrix;
    this.solids.add(this.shaded, this.wire);
    this.object.add(this.solids, this.lines);
    this.object.traverse((part) => Object.assign(part, { frustumCulled: false }));
    this.lines.children.forEach((part, i) => (part.renderOrder = 10 + i));
  }

  show(lines: boolean, solids: boolean): void {
    this.lines.visible = lines;
    this.solids.visible = solids;
  }

  /** The names of the joints whose circles are shown. */
  jointNames(): string[] {
    return this.lines.visible ? this.plan.joints.map((joint) => this.actor.cast.names[joint]!) : [];
  }

  get visible(): boolean {
    return this.lines.visible || this.solids.visible;
  }

  /** Colours lines and rings in `ink`, joints and edges in `accent`, tetrahedra in `body`. */
  colour(ink: string, accent: string, body: string): void {
    this.lineMaterial.color.set(ink);
    (this.circleMaterial.uniforms["ink"]!.value as THREE.Color).set(ink);
    (this.circleMaterial.uniforms["paper"]!.value as THREE.Color).set(accent);
    this.solidMaterial.color.set(body);
    this.wireMaterial.color.set(accent);
  }

  /** Follows the actor's joints, whose world matrices are up to date. */
  update(): void {
    if (!this.visible) return;
    this.actor.jointPositions(this.world);
    this.measure();
    if (this.lines.visible) this.drawLines();
    if (this.solids.visible) this.drawSolids();
  }

  private measure(): void {
    const [end, world] = [new THREE.Vector3(), new THREE.Matrix4()];
    const { segments } = this.plan;
    segments.forEach(([from, to], k) => {
      this.bones.set(this.world.subarray(from * 3, from * 3 + 3), k * 6);
      this.bones.set(this.world.subarray(to * 3, to * 3 + 3), k * 6 + 3);
    });
    this.last.forEach(({ joint, at }, k) => {
      this.bones.set(this.world.subarray(joint * 3, joint * 3 + 3), (segments.length + k) * 6);
      end
        .copy(at)
        .applyMatrix4(world.fromArray(this.actor.jointWorld(joint)))
        .toArray(this.bones, (segments.length + k) * 6 + 3);
    });
  }

  private drawLines(): void {
    this.ends.array.set(this.bones);
    this.plan.joints.forEach((joint, k) =>
      this.circles.array.set(this.world.subarray(joint * 3, joint * 3 + 3), k * 3),
    );
    this.ends.needsUpdate = true;
    this.circles.needsUpdate = true;
  }

  private drawSolids(): void {
    const matrix = new THREE.Matrix4();
    const [start, end] = [new THREE.Vector3(), new THREE.Vector3()];
    for (let k = 0; k < this.bones.length / 6; k++) {
      this.shaded.setMatrixAt(
        k,
        place(matrix, start.fromArray(this.bones, k * 6), end.fromArray(this.bones, k * 6 + 3)),
      );
    }
    this.shaded.instanceMatrix.needsUpdate = true;
  }

  dispose(): void {
    this.object.removeFromParent();
    for (const material of [this.lineMaterial, this.circleMaterial, this.solidMaterial, this.wireMaterial])
      material.dispose();
    this.shaded.dispose();
  }
}
