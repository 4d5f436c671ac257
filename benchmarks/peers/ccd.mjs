// three.js's CCDIKSolver on chains of bones: a line of JSON in ({job, ...}), a line out ({ms}). Only `update` is timed.
import { createInterface } from 'node:readline';
import * as THREE from '../../static/node_modules/three/build/three.module.js';
import { CCDIKSolver } from '../../static/node_modules/three/examples/jsm/animation/CCDIKSolver.js';

const crowds = new Map();

// A chain of `joints` bones, the first `joints - 1` of which turn, with a target; `limit`: radians about each axis, 0 none.
function chainOf(offsets, target, iteration, limit) {
  const bones = offsets.map((offset) => {
    const bone = new THREE.Bone();
    bone.position.fromArray(offset);
    return bone;
  });
  bones.slice(1).forEach((bone, number) => bones[number].add(bone));
  const aim = new THREE.Bone();
  aim.position.fromArray(target);
  const mesh = new THREE.SkinnedMesh(new THREE.BufferGeometry(), new THREE.MeshBasicMaterial());
  mesh.add(bones[0], aim);
  mesh.bind(new THREE.Skeleton([...bones, aim]));
  mesh.updateMatrixWorld(true);
  const bounds = limit
    ? { rotationMin: new THREE.Vector3(-limit, -limit, -limit), rotationMax: new THREE.Vector3(limit, limit, limit) }
    : {};
  const links = bones.slice(0, -1).map((_, number) => ({ index: bones.length - 2 - number, ...bounds }));
  const solver = new CCDIKSolver(mesh, [{ target: bones.length, effector: bones.length - 1, links, iteration }]);
  return { mesh, bones, solver };
}

const jobs = {
  ccd({ crowd: name, offsets, targets, iteration, limit }) {
    if (offsets) crowds.set(name, offsets.map((chain, row) => chainOf(chain, targets[row], iteration, limit)));
    const crowd = crowds.get(name);
    for (const { mesh, bones } of crowd) {
      bones.forEach((bone) => bone.quaternion.identity());
      mesh.updateMatrixWorld(true);
    }
    const start = performance.now();
    for (const { solver } of crowd) solver.update();
    return performance.now() - start;
  },
};

for await (const line of createInterface({ input: process.stdin })) {
  const asked = JSON.parse(line);
  process.stdout.write(`${JSON.stringify({ ms: await jobs[asked.job](asked) })}\n`);
}
