// What three.js shows of two clips on one object, the second one additive: [x, y, z, qx, qy, qz, qw] as JSON on stdout.
// stdin: {base: {times, position, rotation}, over: {…}, time, weight}
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';

const [folder] = process.argv.slice(2);
const three = await import(pathToFileURL(`${folder}/three/build/three.module.js`).href);
const given = JSON.parse(readFileSync(0, 'utf8'));

const clipOf = (name, { times, position, rotation }) =>
  new three.AnimationClip(name, -1, [
    new three.VectorKeyframeTrack('.position', times, position.flat()),
    new three.QuaternionKeyframeTrack('.quaternion', times, rotation.flat()),
  ]);

const object = new three.Object3D();
const mixer = new three.AnimationMixer(object);
const over = three.AnimationUtils.makeClipAdditive(clipOf('over', given.over));
mixer.clipAction(clipOf('base', given.base)).play();
mixer.clipAction(over).play().setEffectiveWeight(given.weight);
mixer.setTime(given.time);
process.stdout.write(JSON.stringify([...object.position.toArray(), ...object.quaternion.toArray()]));
