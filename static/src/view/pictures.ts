/** Pictures of the stage as they are drawn: one moment, or several side by side. */

import { el, token } from "../ui/dom";
import type { Scene } from "./scene";

/** Where the middle of the page's gradient is, and how far it reaches, in shares of width and height. */
const [CENTRE_X, CENTRE_Y, REACH_X, REACH_Y] = [0.5, 0.42, 0.9, 0.8];
/** A moment of a strip is so wide, in shares of its height. */
const NARROW = 0.62;
const LABEL_PIXELS = 24;

export interface Moment {
  picture: HTMLCanvasElement;
  words: string;
}

/** Makes a canvas with its pen. */
function paper(width: number, height: number): [HTMLCanvasElement, CanvasRenderingContext2D] {
  const canvas = el("canvas", { width, height });
  return [canvas, canvas.getContext("2d")!];
}

/** Paints what the page's style shows behind the stage. */
function paintBackground(
  pen: CanvasRenderingContext2D,
  behind: Element,
  width: number,
  height: number,
): void {
  const style = getComputedStyle(behind);
  pen.save();
  pen.translate(CENTRE_X * width, CENTRE_Y * height);
  pen.scale(REACH_X * width, REACH_Y * height);
  const gradient = pen.createRadialGradient(0, 0, 0, 0, 0, 1);
  ["--view-1", "--view-2"].forEach((name, stop) =>
    gradient.addColorStop(stop, style.getPropertyValue(name).trim()),
  );
  pen.fillStyle = gradient;
  pen.fillRect(-2, -2, 4, 4);
  pen.restore();
}

/** Returns the stage as it is now; `transparent`: without background and grid. */
export function capture(scene: Scene, transparent: boolean): HTMLCanvasElement {
  const { canvas, ground } = scene;
  const [picture, pen] = paper(canvas.width, canvas.height);
  if (!transparent) paintBackground(pen, canvas.parentElement ?? canvas, canvas.width, canvas.height);
  ground.mesh.visible = !transparent;
  scene.drawNow(); // the canvas keeps its pixels until this task ends
  pen.drawImage(canvas, 0, 0);
  ground.mesh.visible = true;
  scene.invalidate();
  return picture;
}

/** Returns moments side by side, each the middle of its picture with its words below. */
export function strip(moments: readonly Moment[]): HTMLCanvasElement {
  const { width = 1, height = 1 } = moments[0]?.picture ?? {};
  const wide = Math.round(Math.min(width, NARROW * height));
  const [picture, pen] = paper(wide * moments.length, height + LABEL_PIXELS);
  pen.fillStyle = token("--panel");
  pen.fillRect(0, height, picture.width, LABEL_PIXELS);
  pen.fillStyle = token("--ink");
  pen.font = `500 ${token("--text-m")} ${token("--font")}`;
  Object.assign(pen, { textAlign: "center", textBaseline: "middle" });
  moments.forEach(({ picture: moment, words }, k) => {
    pen.drawImage(moment, (width - wide) / 2, 0, wide, height, k * wide, 0, wide, height);
    pen.fillText(words, (k + 0.5) * wide, height + LABEL_PIXELS / 2);
  });
  return picture;
}

/** Saves a picture as a PNG file of this name. */
export function savePicture(picture: HTMLCanvasElement, name: string): void {
  picture.toBlob((blob) => {
    if (!blob) return;
    const href = URL.createObjectURL(blob);
    el("a", { href, download: name }).click();
    setTimeout(() => URL.revokeObjectURL(href));
  }, "image/png");
}
