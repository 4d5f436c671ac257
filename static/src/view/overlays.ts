/** Draws the bones of all actors of a cast over the skin: lines with circles (RD1), or tetrahedra, shaded, in wire or textured (RD2). */

import * as THREE from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import { type BoneEnd, boneEnds } from "./boneEnds";
import { type BonePlan, planBones } from "./bones";
import type { Crowd } from "./crowd";
import type { Solid } from "./looks";
import { place, tetrahedronGeometry, tetrahedronTexture } from "./tetrahedron";

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
  /** World positions of each bone's start and end, metres. */
  private readonly bones: Float32Array;
  private readonly ends: THREE.InterleavedBuffer;
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
  private readonly texturedMaterial = new THREE.MeshLambertMaterial({
    flatShading: true,
    map: tetrahedronTexture(),
  });
  private readonly wireMaterial = new THREE.MeshBasicMaterial({ wireframe: true });

  constructor(
    private readonly crowd: Crowd,
    pixelRatio: number,
  ) {
    const { cast, model } = crowd;
    this.plan = planBones(cast, model.skinJoints);
    this.last = boneEnds(this.plan, cast, model);
    const actors = cast.actors.length;
    const count = actors * (this.plan.segments.length + this.last.length);
    this.bones = new Float32Array(count * 6);
    const geometry = new LineSegmentsGeometry().setPositions(new Float32Array(Math.max(1, count) * 6));
    this.ends = (geometry.attributes["instanceStart"] as THREE.InterleavedBufferAttribute).data;
    const points = new THREE.BufferGeometry();
    this.circles = new THREE.BufferAttribute(new Float32Array(actors * this.plan.joints.length * 3), 3);
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

  /** `solids`: how the tetrahedra are drawn; null: not at all. */
  show(lines: boolean, solids: Solid | null): void {
    this.lines.visible = lines;
    this.solids.visible = solids !== null;
    this.shaded.visible = solids !== "wireframe";
    this.wire.visible = solids !== "textured";
    this.shaded.material = solids === "textured" ? this.texturedMaterial : this.solidMaterial;
  }

  /** The names of the joints whose circles are shown. */
  jointNames(): string[] {
    return this.lines.visible ? this.plan.joints.map((joint) => this.crowd.cast.names[joint]!) : [];
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
    this.texturedMaterial.color.set(body);
    this.wireMaterial.color.set(accent);
  }

  /** Follows the poses of the actors. */
  update(): void {
    if (!this.visible) return;
    for (let row = 0; row < this.crowd.cast.actors.length; row++) this.measure(row);
    if (this.lines.visible) this.drawLines();
    if (this.solids.visible) this.drawSolids();
  }

  private measure(row: number): void {
    const [end, world] = [new THREE.Vector3(), new THREE.Matrix4()];
    const { segments } = this.plan;
    const { pose } = this.crowd;
    let at = row * (segments.length + this.last.length) * 6;
    const put = (joint: number): void => {
      const e = pose.indexOf(row, joint) + 12;
      for (let k = 0; k < 3; k++) this.bones[at++] = pose.matrices[e + k]!;
    };
    for (const [from, to] of segments) {
      put(from);
      put(to);
    }
    for (const { joint, at: tip } of this.last) {
      put(joint);
      end
        .copy(tip)
        .applyMatrix4(world.fromArray(pose.world(row, joint)))
        .toArray(this.bones, at);
      at += 3;
    }
  }

  private drawLines(): void {
    this.ends.array.set(this.bones);
    const { pose } = this.crowd;
    let at = 0;
    for (let row = 0; row < pose.actors; row++)
      for (const joint of this.plan.joints) {
        const e = pose.indexOf(row, joint) + 12;
        for (let k = 0; k < 3; k++) this.circles.array[at++] = pose.matrices[e + k]!;
      }
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
    const { lineMaterial, circleMaterial, solidMaterial, texturedMaterial, wireMaterial } = this;
    for (const material of [lineMaterial, circleMaterial, solidMaterial, texturedMaterial, wireMaterial])
      material.dispose();
    this.object.traverse((part) => (part as Partial<THREE.Mesh>).geometry?.dispose());
    this.shaded.dispose();
  }
}
