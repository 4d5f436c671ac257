/** Carries a dropped capture (.bvh, .trc) over to a character, and makes a machine that plays it. */

import { signal } from "@preact/signals-core";
import { html, type TemplateResult } from "lit-html";
import * as api from "../../net/api";
import * as machines from "../../net/machines";
import { freeName, putCharacter } from "../../net/upload";
import type { CarriedClip } from "../../net/protocol";
import { boneForm, chosenJoints, lacksJoints, type Skeleton } from "./boneForm";
import { sorted } from "./carriedText";
import { readingForm, readingOf } from "./readingForm";
import { asked, type Step } from "./step";

/** What the dialog offers to an import. */
export interface Stage {
  progress: (share: number) => void;
  signal: AbortSignal;
  /** Asks in any case, with these words; else only if the names of joints do not tell enough. */
  why?: string;
  show: (step: Step) => void;
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

/** Asks which joint is which bone. */
function bonesStep(why: string, fields: TemplateResult, answer: (fields: FormData) => void): Step {
  const isSent = signal(false);
  return {
    title: "Which joint is which bone?",
    focus: "form input",
    sent: (sent) => {
      isSent.value = true;
      answer(sent);
    },
    content: () =>
      html`<p class="import-about" role="status" .textContent=${why}></p>
        <form class="import-form" novalidate>
          ${fields}
          <div class="import-foot">
            <span class="space"></span>
            <button type="submit" class="primary" ?disabled=${isSent.value}>Carry it over</button>
          </div>
        </form>`,
  };
}

async function skeletonOf(key: Skeleton["key"], title: string, character: string): Promise<Skeleton> {
  const [bones, { joints }] = await Promise.all([api.bones(character), api.character(character)]);
  return { key, title, bones, joints: joints.map(({ name }) => name) };
}

/** Carries the clip over; asks for the joints of bones whose names tell nothing. */
async function carry(
  file: File,
  target: string,
  source: string,
  character: string,
  stage: Stage,
): Promise<CarriedClip> {
  const [captured, carrier] = await Promise.all([
    skeletonOf("bones", "joint of the capture", source),
    skeletonOf("target_bones", "joint of the character", target),
  ]);
  const form = html`${boneForm(captured, carrier)}${readingForm(file)}`;
  let why = stage.why ?? "";
  if (lacksJoints(captured) || lacksJoints(carrier))
    why ||= "The names of some joints do not tell which bones they are. Which are they?";
  const show = (answer: (fields: FormData) => void): void => stage.show(bonesStep(why, form, answer));
  for (let fields = new FormData(), isAdded = false; ;) {
    if (why) fields = await asked(stage.signal, show);
    const { adds, ...filter } = readingOf(fields);
    if (adds !== isAdded) {
      const position = adds ? "add" : "replace";
      await putCharacter(source, file, () => undefined, stage.signal, { position });
      isAdded = adds;
    }
    try {
      const bones = { bones: chosenJoints(fields, captured), target_bones: chosenJoints(fields, carrier) };
      const clip = await api.carryClip(target, { source, character, ...bones, ...filter });
      return sorted(clip, captured.bones, carrier.bones);
    } catch (error) {
      if (!lacksBones(error)) throw error;
      why = error.message;
    }
  }
}

/** Makes a machine of the character with the carried clip; removes the character again if there can be none. */
async function machineOf(character: string, report: CarriedClip): Promise<Carried> {
  try {
    const { mapping } = await api.mapping(character);
    await machines.fromCharacter(character, character, mapping, report.root);
    return { machine: character, state: mapping[report.clip] ?? "", report };
  } catch (error) {
    await api.removeCharacter(character).catch(() => undefined);
    throw error;
  }
}

/**
 * Uploads the capture, carries it over to `target`, and makes a machine of the character with the new clip. The
 * uploaded capture itself is removed again.
 */
export async function importCapture(file: File, target: string, stage: Stage): Promise<Carried> {
  const source = await freeName(file.name);
  await putCharacter(source, file, stage.progress, stage.signal);
  try {
    const character = await freeName(`${target.replace(/\.[0-9a-f]{8}$/, "")}-${file.name}`);
    const report = await carry(file, target, source, character, stage);
    return await machineOf(character, report);
  } finally {
    await api.removeCharacter(source).catch(() => undefined);
  }
}
