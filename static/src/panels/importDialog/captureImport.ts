/** Carries a dropped capture (.bvh, .trc) over to a character, and makes a machine that plays it. */

import * as api from "../../net/api";
import * as machines from "../../net/machines";
import { freeName, putCharacter } from "../../net/upload";
import type { CarriedClip } from "../../net/protocol";
import { BoneForm } from "./boneForm";
import { sorted } from "./carriedText";
import { ReadingForm } from "./readingForm";

/** What the dialog offers to an import. */
export interface Stage {
  progress: (share: number) => void;
  signal: AbortSignal;
  /** Asks in any case, with these words; else only if the names of joints do not tell enough. */
  why?: string;
  /** Shows the forms in the dialog; resolves when they are sent. */
  ask: (why: string, ...forms: HTMLElement[]) => Promise<void>;
}

/** What a capture has become. */
export interface Carried {
  machine: string;
  state: string;
  report: CarriedClip;
}

export const isCapture = (file: File): boolean => /\.(bvh|trc)$/i.test(file.name);

/** Returns whether the server could not tell the bones of the two skeletons. */
const lacksBones = (error: unknown): error is api.ApiError =>
  error instanceof api.ApiError &&
  error.status === 422 &&
  error.places.some(({ field }) => /(^|\.)(target_)?bones$/.test(field));

/** Carries the clip over; asks for the joints of bones whose names tell nothing. */
async function carry(
  file: File,
  target: string,
  source: string,
  character: string,
  stage: Stage,
): Promise<CarriedClip> {
  const [bones, joints, targetBones, targetJoints] = await Promise.all([
    api.bones(source),
    api.character(source),
    api.bones(target),
    api.character(target),
  ]);
  const form = new BoneForm(
    { title: "joint of the capture", bones, joints: joints.joints.map(({ name }) => name) },
    {
      title: "joint of the character",
      bones: targetBones,
      joints: targetJoints.joints.map(({ name }) => name),
    },
  );
  const reading = new ReadingForm(file);
  let why = stage.why ?? "";
  if (form.open) why ||= "The names of some joints do not tell which bones they are. Which are they?";
  for (;;) {
    if (why) await stage.ask(why, form.element, reading.element);
    await reading.apply(source, stage.signal);
    try {
      const wish = { source, character, ...form.chosen(), ...reading.filter() };
      return sorted(await api.carryClip(target, wish), bones, targetBones);
    } catch (error) {
      if (!lacksBones(error)) throw error;
      why = error.message;
    }
  }
}

/**
 * Uploads the capture, carries it over to `target`, and makes a machine of the character with the new clip. The
 * uploaded capture itself is removed again; a character that no machine was made of as well.
 */
export async function importCapture(file: File, target: string, stage: Stage): Promise<Carried> {
  const source = await freeName(file.name);
  await putCharacter(source, file, stage.progress, stage.signal);
  let character = "";
  try {
    character = await freeName(`${target.replace(/\.[0-9a-f]{8}$/, "")}-${file.name}`);
    const report = await carry(file, target, source, character, stage);
    const { mapping } = await api.mapping(character);
    await machines.fromCharacter(character, character, mapping, report.root);
    return { machine: character, state: mapping[report.clip] ?? "", report };
  } catch (error) {
    if (character) await api.removeCharacter(character).catch(() => undefined);
    throw error;
  } finally {
    await api.removeCharacter(source).catch(() => undefined);
  }
}
