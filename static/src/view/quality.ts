/** Chooses the quality of drawing: `low` has no antialiasing, no shadow map, a pixel ratio of 1, and at most 30
 * drawings a second, since a software renderer takes the processors that the server needs. */

export type Quality = "low" | "high";

/** Drawings a second. */
const MOST_FPS: Record<Quality, number> = { low: 30, high: Infinity };
/** Of the time between two drawings, how much must be over: no browser keeps time exactly. */
const NEARLY = 0.9;

const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;

/** Returns the quality in the address (`?quality=`), else `low` for a software renderer. */
export function chooseQuality(rendererName: string, search: string): Quality {
  const wanted = new URLSearchParams(search).get("quality");
  if (wanted === "low" || wanted === "high") return wanted;
  return SOFTWARE.test(rendererName) ? "low" : "high";
}

/** Returns the seconds between two drawings at least; an address with `?fps=` spares a battery or a processor. */
export function leastStep_s(quality: Quality, search: string): number {
  const wanted = Number(new URLSearchParams(search).get("fps"));
  return NEARLY / Math.min(MOST_FPS[quality], wanted > 0 ? wanted : Infinity);
}

/** Returns the name of the WebGL renderer, "" without WebGL 2. */
export function rendererName(): string {
  const context = document.createElement("canvas").getContext("webgl2");
  if (!context) return "";
  const info = context.getExtension("WEBGL_debug_renderer_info");
  const name: unknown = context.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : context.RENDERER);
  context.getExtension("WEBGL_lose_context")?.loseContext();
  return typeof name === "string" ? name : "WebGL";
}
