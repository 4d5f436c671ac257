// A .glb as three.js reads it: the places of all vertices at a time of its first animation, as float32 on stdout.
import { readFile } from 'node:fs/promises';
import { pathToFileURL } from 'node:url';

const [folder, path, time] = process.argv.slice(2);
const from = (name) => import(pathToFileURL(`${folder}/three/${name}`).href);
const { AnimationMixer, Vector3 } = await from('build/three.module.js');
const { GLTFLoader } = await from('examples/jsm/loaders/GLTFLoader.js');

const data = await readFile(path);
const gltf = await new GLTFLoader().parseAsync(data.buffer.slice(data.byteOffset, data.byteOffset + data.byteLength), '');
if (gltf.animations.length) {
  const mixer = new AnimationMixer(gltf.scene);
  mixer.clipAction(gltf.animations[0]).play();
  mixer.setTime(Number(time));
}
gltf.scene.updateMatrixWorld(true);
const places = [];
const vertex = new Vector3();
gltf.scene.traverse((object) => {
  if (!object.isMesh) return;
  object.skeleton?.update();
  for (let row = 0; row < object.geometry.attributes.position.count; row++) {
    places.push(...object.getVertexPosition(row, vertex).applyMatrix4(object.matrixWorld).toArray());
  }
});
process.stdout.write(Buffer.from(new Float32Array(places).buffer));
