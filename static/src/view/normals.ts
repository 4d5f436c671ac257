/** Shows a skin's normals: as colours, and as a line from each vertex. */

import * as THREE from "three";
import { CrowdGeometry, CrowdMesh } from "./crowdMesh";

/** Length of the lines, relative to the radius of the body. */
const REACH = 0.06;
const twins = new WeakMap<THREE.Mesh, THREE.Mesh>();

/** The material of bodies whose normals are shown. */
export const normalMaterial = new THREE.MeshNormalMaterial();
export const flatNormalMaterial = new THREE.MeshNormalMaterial({ flatShading: true });

/** Draws the end of each line a normal's length away, after morphs and skin have moved vertex and normal. */
function lineMaterial(reach: number): THREE.MeshNormalMaterial {
  const material = new THREE.MeshNormalMaterial({ wireframe: true });
  material.onBeforeCompile = (shader) => {
    shader.uniforms["reach"] = { value: reach };
    shader.vertexShader =
      "attribute float tip;\nuniform float reach;\n" +
      shader.vertexShader.replace(
        "#include <skinning_vertex>",
        "#include <skinning_vertex>\ntransformed += normalize(objectNormal) * reach * tip;",
      );
  };
  return material;
}

/** Returns every element of an attribute twice: for the start and the end of its line. */
function doubled(attribute: THREE.BufferAttribute | THREE.InterleavedBufferAttribute): THREE.BufferAttribute {
  const { count, itemSize } = attribute;
  const out = new THREE.BufferAttribute(new Float32Array(2 * count * itemSize), itemSize);
  fill(out, attribute);
  return out;
}

function fill(
  out: THREE.BufferAttribute,
  attribute: THREE.BufferAttribute | THREE.InterleavedBufferAttribute,
): void {
  for (let i = 0; i < attribute.count; i++)
    for (let k = 0; k < attribute.itemSize; k++) {
      const value = attribute.getComponent(i, k);
      out.setComponent(2 * i, k, value);
      out.setComponent(2 * i + 1, k, value);
    }
  out.needsUpdate = true;
}

const COPIED = ["position", "normal", "skinIndex", "skinWeight", "moreJoints", "moreWeights"];
function linesOf(source: THREE.BufferGeometry): THREE.BufferGeometry {
  const { attributes, morphAttributes, morphTargetsRelative } = source;
  const lines =
    source instanceof CrowdGeometry ? new CrowdGeometry(source.roster) : new THREE.BufferGeometry();
  for (const name of COPIED) if (attributes[name]) lines.setAttribute(name, doubled(attributes[name]));
  for (const [name, targets] of Object.entries(morphAttributes))
    if (targets && (name === "position" || name === "normal"))
      lines.morphAttributes[name] = targets.map(doubled);
  lines.morphTargetsRelative = morphTargetsRelative;
  const count = attributes["position"]!.count;
  lines.setAttribute(
    "tip",
    new THREE.BufferAttribute(
      Float32Array.from({ length: 2 * count }, (_, i) => i % 2),
      1,
    ),
  );
  // A triangle with two equal corners, in wire, is a line.
  lines.setIndex(Array.from({ length: count }, (_, i) => [2 * i, 2 * i + 1, 2 * i + 1]).flat());
  return lines;
}

function twinOf(mesh: THREE.Mesh): THREE.Mesh {
  const position = mesh.geometry.getAttribute("position") as THREE.BufferAttribute;
  const size = new THREE.Box3().setFromBufferAttribute(position).getSize(new THREE.Vector3()).length();
  const material = lineMaterial((REACH * size) / 2);
  const lines = linesOf(mesh.geometry);
  const twin = mesh instanceof CrowdMesh ? mesh.twin(lines, material) : new THREE.Mesh(lines, material);
  twin.frustumCulled = false;
  mesh.add(twin);
  twins.set(mesh, twin);
  return twin;
}

/** Shows or hides the lines of a body's normals; a body without normals has none. */
export function showNormals(mesh: THREE.Mesh, shown: boolean): void {
  const known = twins.get(mesh);
  if (known) known.visible = shown;
  else if (shown && mesh.geometry.hasAttribute("normal")) twinOf(mesh);
}

/** Moves the lines after the server has moved vertices and normals. */
export function refreshNormals(mesh: THREE.Mesh): void {
  const twin = twins.get(mesh);
  if (!twin?.visible) return;
  for (const name of ["position", "normal"])
    fill(twin.geometry.attributes[name] as THREE.BufferAttribute, mesh.geometry.attributes[name]!);
}

/** Frees the lines of a body that is gone. */
export function dropNormals(mesh: THREE.Mesh): void {
  const twin = twins.get(mesh);
  twin?.removeFromParent();
  twin?.geometry.dispose();
  twins.delete(mesh);
}
