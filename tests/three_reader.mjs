// Reads GLB files from standard input (each behind its length, uint32) with three.js; prints, for each, the world positions of all vertices
// at a time of its first animation. `node three_reader.mjs PATH_OF_THREE SECONDS`.
const [path, seconds] = process.argv.slice(2);
const THREE = await import(`${path}/build/three.module.js`);
const { GLTFLoader } = await import(`${path}/examples/jsm/loaders/GLTFLoader.js`);

const loader = new GLTFLoader();
loader.register(() => ({ name: 'NO_IMAGES', loadTexture: async () => new THREE.Texture() })); // Node decodes no images

function vertices(mesh) {
  const point = new THREE.Vector3();
  const found = [];
  for (let row = 0; row < mesh.geometry.attributes.position.count; row++) {
    mesh.getVertexPosition(row, point).applyMatrix4(mesh.matrixWorld);
    found.push(point.x, point.y, point.z);
  }
  return found;
}

async function read(data) {
  const gltf = await loader.parseAsync(data, '');
  if (gltf.animations.length) {
    const mixer = new THREE.AnimationMixer(gltf.scene);
    const action = mixer.clipAction(gltf.animations[0]);
    action.setLoop(THREE.LoopOnce);
    action.clampWhenFinished = true;
    action.play();
    mixer.update(Number(seconds));
  }
  gltf.scene.updateMatrixWorld(true);
  const found = [];
  gltf.scene.traverse((object) => {
    if (object.isSkinnedMesh) object.skeleton.update();
    if (object.isMesh) found.push(...vertices(object));
  });
  return found;
}

const chunks = [];
for await (const chunk of process.stdin) chunks.push(chunk);
const all = Buffer.concat(chunks);
const answers = [];
for (let at = 0; at < all.length; ) {
  const size = all.readUInt32LE(at);
  answers.push(await read(Uint8Array.from(all.subarray(at + 4, at + 4 + size)).buffer));
  at += 4 + size;
}
process.stdout.write(JSON.stringify(answers));
