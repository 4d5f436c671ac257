// What three.js's CCDIKSolver makes of chains: [[[x, y, z, w], …], …] on stdout, the rotations of all bones.
// stdin: {translation, rotation, target, iteration}; a chain is a root and the bones below it, one after the other
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';

const [folder] = process.argv.slice(2);
const three = await import(pathToFileURL(`${folder}/three/build/three.module.js`).href);
const { CCDIKSolver } = await import(pathToFileURL(`${folder}/three/examples/jsm/animation/CCDIKSolver.js`).href);
const given = JSON.parse(readFileSync(0, 'utf8'));

function solved(translation, rotation, target) {
  const bones = translation.map((place, number) => {
    const bone = new three.Bone();
    bone.position.fromArray(place);
    bone.quaternion.fromArray(rotation[number]);
    return bone;
  });
  bones.slice(1).forEach((bone, number) => bones[number].add(bone));
  const aim = new three.Bone();
  aim.position.fromArray(target);
  const mesh = new three.SkinnedMesh(new three.BufferGeometry(), new three.MeshBasicMaterial());
  mesh.add(bones[0], aim);
  mesh.bind(new three.Skeleton([...bones, aim]));
  mesh.updateMatrixWorld(true);
  const links = bones.slice(1, -1).map((_, number) => ({ index: bones.length - 2 - number }));
  new CCDIKSolver(mesh, [{ target: bones.length, effector: bones.length - 1, links, iteration: given.iteration }]).update();
  return bones.map((bone) => bone.quaternion.toArray());
}

process.stdout.write(
  JSON.stringify(given.target.map((target, row) => solved(given.translation[row], given.rotation[row], target))),
);
