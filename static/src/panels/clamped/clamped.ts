/** Says which joints of the watched actor are at their limits, and by how much they were clamped (SK6). */

import "./clamped.css";
import { actorFacts } from "../../net/actors";
import type { ClampedJoint } from "../../net/protocol";
import type { App } from "../../view/app";
import { say } from "../../ui/dom";

const READ_MS = 400;

/** Returns the sentence about clamped joints. */
export function clampedWords(clamped: readonly ClampedJoint[]): string {
  if (!clamped.length) return "limits: all joints inside";
  const parts = clamped.map(({ joint, angle_deg, distance, by: cause }) => {
    const by = [
      ...(angle_deg >= 0.01 ? [`${angle_deg.toFixed(1)}°`] : []),
      ...(distance >= 1e-4 ? [`${(100 * distance).toFixed(1)} cm`] : []),
    ];
    return `${joint} by ${by.join(", ") || "a trace"}${cause === "solver" ? " (reaching)" : ""}`;
  });
  return `clamped: ${parts.join("; ")}`;
}

/** Reads the actor's facts now and then, while its machine has limits. */
export function clampedPanel(host: HTMLElement, app: App): void {
  app.machine.info.subscribe((machine) => (host.hidden = !machine?.limits.length));
  let reading = false;
  setInterval(() => {
    const actor = app.selection.actor.value;
    if (host.hidden || reading || actor === null || document.hidden) return;
    reading = true;
    void actorFacts(app.stage.id, actor)
      .then((facts) => say(host, clampedWords(facts.clamped)))
      .catch(() => undefined)
      .finally(() => (reading = false));
  }, READ_MS);
}
