/**
 * The form that says which joint is which bone, for a capture and the character that it is carried over to. Names
 * of joints come from files of strangers, so they are set as text.
 */

import "./mappingForm.css";
import type { Bones } from "../../net/protocol";
import { el } from "../../ui/dom";

/** One of the two skeletons. */
export interface Skeleton {
  title: string;
  bones: Bones;
  joints: string[];
}

/** `LeftUpperLeg` -> `left upper leg`. */
export const wordsOf = (bone: string): string => bone.replace(/(?!^)[A-Z]/g, " $&").toLowerCase();

export class BoneForm {
  readonly element: HTMLElement;
  /** Whether a bone that is needed has no joint yet. */
  readonly open: boolean;
  private readonly inputs: Record<"bones" | "target_bones", Map<string, HTMLInputElement>>;

  constructor(source: Skeleton, target: Skeleton) {
    this.inputs = { bones: new Map(), target_bones: new Map() };
    const missing = ({ bones }: Skeleton): string[] => bones.needed.filter((bone) => !(bone in bones.bones));
    this.open = missing(source).length + missing(target).length > 0;
    const head = el(
      "div",
      { class: "map-row bone-row map-head", "aria-hidden": "true" },
      el("span", {}, "bone"),
      el("span", {}, source.title),
      el("span", {}, target.title),
    );
    const rows = source.bones.needed.map((bone) => this.row(bone, source, target));
    const others = source.bones.known.filter((bone) => !source.bones.needed.includes(bone));
    const more = el(
      "details",
      { class: "more-bones" },
      el("summary", {}, "arms, spine, head and fingers"),
      ...others.map((bone) => this.row(bone, source, target)),
    );
    this.element = el(
      "div",
      { class: "map" },
      head,
      ...rows,
      more,
      this.list("joints-source", source),
      this.list("joints-target", target),
    );
  }

  private list(id: string, { joints }: Skeleton): HTMLElement {
    return el("datalist", { id }, ...joints.map((joint) => el("option", { value: joint })));
  }

  private row(bone: string, source: Skeleton, target: Skeleton): HTMLElement {
    return el(
      "div",
      { class: "map-row bone-row" },
      el("span", { class: "map-clip" }, wordsOf(bone)),
      this.input("bones", bone, source, "joints-source"),
      this.input("target_bones", bone, target, "joints-target"),
    );
  }

  private input(key: "bones" | "target_bones", bone: string, skeleton: Skeleton, list: string): HTMLElement {
    const input = el("input", {
      type: "text",
      list,
      maxlength: 200,
      spellcheck: "false",
      autocomplete: "off",
      placeholder: "none",
      "aria-label": `${wordsOf(bone)}: ${skeleton.title}`,
    });
    input.defaultValue = skeleton.bones.bones[bone] ?? "";
    this.inputs[key].set(bone, input);
    return input;
  }

  /** Returns the joints that differ from what the names told; "": the bone has none. */
  chosen(): Record<"bones" | "target_bones", Record<string, string>> {
    const of = (key: "bones" | "target_bones"): Record<string, string> =>
      Object.fromEntries(
        [...this.inputs[key]]
          .map(([bone, input]) => [bone, input.value.trim(), input.defaultValue] as const)
          .filter(([, joint, told]) => joint !== told)
          .map(([bone, joint]) => [bone, joint]),
      );
    return { bones: of("bones"), target_bones: of("target_bones") };
  }
}
