/** Chooses the quality of drawing: `low` has no antialiasing, no shadow map, a pixel ratio of 1, and at most 30
 * drawings a second, since a software renderer takes the processors that the server needs. */

export type Quality = "low" | "high";

/** Seconds between two drawings at least; a little less than a thirtieth, as no browser keeps time exactly. */
export const LEAST_STEP_S: Record<Quality, number> = { low: 0.03, high: 0 };

const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;

/** Returns the quality in the address (`?quality=`), else `low` for a software renderer. */
export function chooseQuality(rendererName: string, search: string): Quality {
  const wanted = new URLSearchParams(search).get("quality");
  if (wanted === "low" || wanted === "high") return wanted;
  return SOFTWARE.test(rendererName) ? "low" : "high";
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
