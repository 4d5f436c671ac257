/** Stands in for a model that cannot be loaded: a sign in its place says why. */

import * as THREE from "three";
import type { Model } from "./model";

const [WIDTH, HEIGHT, FONT] = [640, 200, 30];
const [METRES, EYES] = [1.6, 1];

function lines(text: string, pen: CanvasRenderingContext2D, width: number): string[] {
  const rows: string[] = [];
  for (const word of text.split(/\s+/)) {
    const longer = rows.length ? `${rows.at(-1)} ${word}` : word;
    if (rows.length && pen.measureText(longer).width <= width) rows[rows.length - 1] = longer;
    else rows.push(word);
  }
  return rows.slice(0, 4);
}

function picture(text: string): THREE.CanvasTexture {
  const canvas = Object.assign(document.createElement("canvas"), { width: WIDTH, height: HEIGHT });
  const pen = canvas.getContext("2d")!;
  pen.fillStyle = "#fff4ef";
  pen.strokeStyle = "#b3400d";
  pen.lineWidth = 6;
  pen.beginPath();
  pen.roundRect(3, 3, WIDTH - 6, HEIGHT - 6, 18);
  pen.fill();
  pen.stroke();
  pen.fillStyle = "#5c1f04";
  pen.font = `${FONT}px system-ui, sans-serif`;
  pen.textAlign = "center";
  const rows = lines(text, pen, WIDTH - 60);
  rows.forEach((row, k) =>
    pen.fillText(row, WIDTH / 2, HEIGHT / 2 + FONT * 1.3 * (k + 0.8 - rows.length / 2)),
  );
  const texture = new THREE.CanvasTexture(canvas);
  texture.colorSpace = THREE.SRGBColorSpace;
  return texture;
}

/** Makes the stand-in for the model at `url`; `wrong` is what the page says about it. */
export function missingModel(url: string, wrong: string): Model {
  const sign = new THREE.Sprite(new THREE.SpriteMaterial({ map: picture(wrong), toneMapped: false }));
  sign.scale.set(METRES, (METRES * HEIGHT) / WIDTH, 1);
  sign.position.y = EYES;
  const scene = new THREE.Group().add(sign);
  const none = { nodes: [], animations: [], targets: [], levels: [], materials: new Map(), materialCount: 0 };
  return { url, scene, wrong, ...none, skinJoints: new Set(), skinEnds: new Map() };
}
