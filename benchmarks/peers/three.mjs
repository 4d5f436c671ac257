// three.js in Node, one job after the other: a line of JSON in ({job, ...}), a line out ({ms}). Only the work itself is timed.
import { readFile } from 'node:fs/promises';
import { createInterface } from 'node:readline';
import * as THREE from '../../static/node_modules/three/build/three.module.js';
import { GLTFExporter } from '../../static/node_modules/three/examples/jsm/exporters/GLTFExporter.js';
import { GLTFLoader } from '../../static/node_modules/three/examples/jsm/loaders/GLTFLoader.js';

// What GLTFExporter needs of a browser.
globalThis.FileReader = class {
  readAsArrayBuffer(blob) {
    blob.arrayBuffer().then((buffer) => {
      this.result = buffer;
      this.onloadend();
    });
  }
};

const files = new Map();
const models = new Map();

async function bytes(path) {
  if (!files.has(path)) {
    const data = await readFile(path);
    files.set(path, data.buffer.slice(data.byteOffset, data.byteOffset + data.byteLength));
  }
  return files.get(path);
}

async function model(path) {
  if (!models.has(path)) {
    const gltf = await new GLTFLoader().parseAsync(await bytes(path), '');
    const mixer = new THREE.AnimationMixer(gltf.scene);
    mixer.clipAction(gltf.animations[0]).play();
    const meshes = [];
    gltf.scene.traverse((object) => object.isMesh && meshes.push(object));
    models.set(path, { gltf, mixer, meshes });
  }
  return models.get(path);
}

// Positions and normals of skinned meshes as three.js moves them on the CPU, vertex by vertex.
function skinned(mesh) {
  const { position, normal } = mesh.geometry.attributes;
  const geometry = new THREE.BufferGeometry();
  const points = new Float32Array(position.count * 3);
  const turned = new Float32Array(position.count * 3);
  const vector = new THREE.Vector3();
  const origin = mesh.applyBoneTransform(0, new THREE.Vector3());
  for (let row = 0; row < position.count; row++) {
    mesh.applyBoneTransform(row, vector.fromBufferAttribute(position, row)).toArray(points, 3 * row);
    mesh.applyBoneTransform(row, vector.fromBufferAttribute(normal, row)).sub(origin).normalize().toArray(turned, 3 * row);
  }
  geometry.setAttribute('position', new THREE.BufferAttribute(points, 3));
  geometry.setAttribute('normal', new THREE.BufferAttribute(turned, 3));
  geometry.setIndex(mesh.geometry.index);
  return geometry;
}

const jobs = {
  async load({ path }) {
    const data = await bytes(path);
    const start = performance.now();
    await new GLTFLoader().parseAsync(data, '');
    return performance.now() - start;
  },
  async pose({ path, actors }) {
    const { mixer, gltf } = await model(path);
    const start = performance.now();
    for (let actor = 0; actor < actors; actor++) {
      mixer.setTime((0.37 * actor) % 1);
      gltf.scene.updateMatrixWorld(true);
    }
    return performance.now() - start;
  },
  async skin({ path }) {
    const { meshes, gltf } = await model(path);
    gltf.scene.updateMatrixWorld(true);
    const start = performance.now();
    meshes.forEach(skinned);
    return performance.now() - start;
  },
  async morph({ path }) {
    const { meshes } = await model(path);
    const vector = new THREE.Vector3();
    const start = performance.now();
    for (const mesh of meshes) {
      for (let row = 0; row < mesh.geometry.attributes.position.count; row++) mesh.getVertexPosition(row, vector);
    }
    return performance.now() - start;
  },
  // A frame as a user of three.js would write it: the figure's vertices in a geometry, exported. `posed`: only the export is timed.
  async frame({ path, posed }) {
    const { meshes, gltf } = await model(path);
    gltf.scene.updateMatrixWorld(true);
    const scene = new THREE.Scene();
    let start = performance.now();
    meshes.forEach((mesh) => scene.add(new THREE.Mesh(skinned(mesh), new THREE.MeshStandardMaterial())));
    if (posed) start = performance.now();
    await new GLTFExporter().parseAsync(scene, { binary: true });
    return performance.now() - start;
  },
};

for await (const line of createInterface({ input: process.stdin })) {
  const asked = JSON.parse(line);
  process.stdout.write(`${JSON.stringify({ ms: await jobs[asked.job](asked) })}\n`);
}
