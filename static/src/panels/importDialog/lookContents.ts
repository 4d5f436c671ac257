/** Lists what a dropped model holds: notes, meshes, morph targets, joints, materials and textures, each folded. */

import { html, nothing, type TemplateResult } from "lit-html";
import type * as api from "../../net/api";
import { plural, size } from "../../ui/amounts";
import type { LookedMesh, LookedModel } from "../../view/lookedModel";

/** The facts that the server tells of a character. */
export type Facts = Awaited<ReturnType<typeof api.character>>;

const folded = (title: string, rows: readonly TemplateResult[]): TemplateResult | typeof nothing =>
  rows.length
    ? html`<details>
        <summary>${title}</summary>
        <ul>
          ${rows.map((row) => html`<li>${row}</li>`)}
        </ul>
      </details>`
    : nothing;

const named = (name: string, facts: string): TemplateResult =>
  html`<span class="look-name" .textContent=${name}></span>
    <span class="look-facts" .textContent=${facts}></span>`;

function meshRow(mesh: LookedMesh, model: LookedModel): TemplateResult {
  return html`<label>
    <input
      type="checkbox"
      .checked=${!model.hidden.value.has(mesh)}
      @change=${({ target }: Event) => model.hide(mesh, !(target as HTMLInputElement).checked)}
    />
    ${named(mesh.name, plural(mesh.triangles, "triangle"))}
  </label>`;
}

function targetRow(target: string, model: LookedModel): TemplateResult {
  const weight = model.weights.value[target] ?? 0;
  return html`<label>
    ${named(target, weight.toFixed(2))}
    <input
      type="range"
      min="0"
      max="1"
      step="0.01"
      .value=${String(weight)}
      @input=${({ target: { value } }: { target: HTMLInputElement }) => model.setWeight(target, Number(value))}
    />
  </label>`;
}

/** Returns how many joints are above a joint. */
function depthOf(joints: Facts["joints"], joint: number): number {
  let depth = 0;
  for (let above = joints[joint]!.parent; above >= 0; above = joints[above]!.parent) depth++;
  return depth;
}

/** Indents with letters: the page's policy allows no styles in the markup. */
function jointRow(joints: Facts["joints"], joint: number): TemplateResult {
  const indent = "  ".repeat(depthOf(joints, joint));
  return html`<span class="look-joint" .textContent=${indent + joints[joint]!.name}></span>`;
}

function materialFacts({ alpha, double_sided, textures }: Facts["materials"][number]): string {
  const pictures = Object.keys(textures).map((use) => use.replace(/Texture$/, ""));
  return [alpha === "OPAQUE" ? "" : alpha, double_sided ? "both sides" : "", ...pictures]
    .filter(Boolean)
    .join(" · ");
}

const textureFacts = ({ type, width, height, bytes }: Facts["textures"][number]): string =>
  [type, width && height ? `${width} × ${height}` : "", size(bytes)].filter(Boolean).join(" · ");

/** Draws the lists. The list of meshes and the list of morph targets are empty until the model is loaded. */
export function contents(facts: Facts, model: LookedModel | null): TemplateResult {
  const { notes, joints, materials, textures, triangles } = facts;
  const [meshes, targets] = [model?.meshes ?? [], model?.targets ?? []];
  return html`${folded(
    plural(notes.length, "note"),
    notes.map((note) => html`<span .textContent=${note}></span>`),
  )}
  ${folded(
    `${plural(meshes.length, "mesh", "meshes")}, ${plural(triangles, "triangle")}`,
    meshes.map((mesh) => meshRow(mesh, model!)),
  )}
  ${folded(
    plural(targets.length, "morph target"),
    targets.map((target) => targetRow(target, model!)),
  )}
  ${folded(
    plural(joints.length, "joint"),
    joints.map((_, joint) => jointRow(joints, joint)),
  )}
  ${folded(
    plural(materials.length, "material"),
    materials.map((material) => named(material.name, materialFacts(material))),
  )}
  ${folded(
    plural(textures.length, "texture"),
    textures.map((texture) => named(texture.name, textureFacts(texture))),
  )}`;
}
