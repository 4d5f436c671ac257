/** How much the machine can draw: `low` has no antialiasing, no shadow map and one pixel a pixel. */

export type Quality = "low" | "high";

const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;

/** What the user asked for in the address (`?quality=`), else what the renderer's name suggests. */
export function chooseQuality(rendererName: string, search: string): Quality {
  const asked = new URLSearchParams(search).get("quality");
  if (asked === "low" || asked === "high") return asked;
  return SOFTWARE.test(rendererName) ? "low" : "high";
}

/** The name of what draws WebGL here, "" where there is no WebGL 2. */
export function rendererName(): string {
  const context = document.createElement("canvas").getContext("webgl2");
  if (!context) return "";
  const info = context.getExtension("WEBGL_debug_renderer_info");
  const name: unknown = context.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : context.RENDERER);
  context.getExtension("WEBGL_lose_context")?.loseContext();
  return typeof name === "string" ? name : "WebGL";
}
