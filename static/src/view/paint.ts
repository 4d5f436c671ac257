/** Paints skins with their materials, the weights of a bone, their glue triangles, or their normals. */

import * as THREE from "three";
import type { Body } from "./bodies";
import type { Crowd } from "./crowd";
import { bonesOf, GLUE, glueMaterial } from "./glue";
import { heat, heatMaterial } from "./heat";
import type { Looks, Paint } from "./looks";
import { flatNormalMaterial, normalMaterial, showNormals } from "./normals";

/** The material of each body that has another one at present. */
const owns = new WeakMap<THREE.Mesh, THREE.Material | THREE.Material[]>();

function materialFor(mesh: THREE.Mesh, paint: Paint): THREE.Material | THREE.Material[] {
  const own = owns.get(mesh) ?? mesh.material;
  owns.set(mesh, own);
  if (paint === "weights") return heatMaterial;
  if (paint === "glue") return glueMaterial;
  if (paint === "normals") return mesh.geometry.hasAttribute("normal") ? normalMaterial : flatNormalMaterial;
  return own;
}

function dress(bodies: readonly Body[], paint: Paint): void {
  for (const body of bodies) {
    if (!(body instanceof THREE.Mesh)) continue;
    body.material = materialFor(body, paint);
    showNormals(body, paint === "normals");
  }
}

type Numbers = (crowd: Crowd, body: Body) => Float32Array;

/** Returns the numbers of the vertices of each primitive of a crowd's model, in the order of the file. */
function ofPrimitives(crowd: Crowd, numbers: Numbers): Float32Array[] {
  const found: Float32Array[] = [];
  crowd.parts.parts.forEach(({ sources }, k) => {
    const all = numbers(crowd, crowd.bodies[k]!);
    for (const { primitive, firstVertex, vertices } of sources)
      found[primitive] = all.subarray(firstVertex, firstVertex + vertices);
  });
  return found;
}

/** Gives every body a number for each vertex, in an attribute. */
function giveNumbers(
  crowds: readonly Crowd[],
  streamed: readonly Body[],
  numbers: Numbers,
  name: string,
): void {
  for (const crowd of crowds) for (const body of crowd.bodies) heat(body, numbers(crowd, body), name);
  const shown = crowds.flatMap((crowd) => crowd.cast.actors.flatMap(() => ofPrimitives(crowd, numbers)));
  streamed.forEach((body, i) => {
    const { count } = body.geometry.getAttribute("position");
    heat(body, shown[i]?.length === count ? shown[i] : new Float32Array(count), name);
  });
}

/** Paints the bodies of the crowds and of the glb stream: the primitives of each actor, cast by cast. */
export function paintSkins(crowds: readonly Crowd[], streamed: readonly Body[], looks: Looks): void {
  const paint = looks.paint.value;
  const joint = looks.bone.value;
  if (paint === "weights") {
    giveNumbers(crowds, streamed, (crowd, body) => crowd.weights(body, joint), "heat");
  }
  if (paint === "glue") giveNumbers(crowds, streamed, (_, body) => bonesOf(body.geometry), GLUE);
  dress(
    crowds.flatMap(({ bodies }) => bodies),
    paint,
  );
  dress(streamed, paint);
}
