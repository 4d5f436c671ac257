/**
 * Keeps the address in step with what the page shows, so that you can reload and share it. Another stage is another
 * page of the browser's history: Back and Forward lead to the stages that you watched, as you left them.
 */

import { effect } from "@preact/signals-core";
import { type Address, addressWith, readAddress } from "./address";
import type { State } from "./state";

/** Browsers take about three changes of the address a second. */
const REST_MS = 350;

/** Returns the address of what the page shows. */
export function shownAddress(state: State): Address {
  const { inspection, stage, stages, selection, playback, viewpoint } = state;
  const { stage: id = "main" } = stage.hello.value ?? {};
  const actor = selection.actor.value;
  return {
    stage: id === "main" ? null : id,
    opening: stages.openingOf(id),
    actor: actor === stage.firstActor ? null : actor,
    layer: selection.layer.value > 0 ? (selection.cast?.layers[selection.layer.value] ?? null) : null,
    tick: playback.looking.value,
    why: inspection.why.value,
    camera: viewpoint.chosen.value,
    view: viewpoint.mode.value === "follow" ? null : viewpoint.mode.value,
  };
}

/** Opens what the address names, and keeps the address from then on. */
export function keepAddress(state: State): void {
  const { inspection, stage, stages, session, selection, machine, playback, viewpoint } = state;
  // You did not choose the next stage now: the address did, or the server.
  let isLed = true;
  let asked: Address | null = null;
  let layer: string | null = null;

  function open(): void {
    isLed = true;
    asked = readAddress();
    void stages.begin(asked.stage, asked.opening);
  }

  function showLayer(): void {
    if (layer === null || !machine.isActors) return;
    selection.layer.value = Math.max(0, selection.cast?.layers.indexOf(layer) ?? 0);
    layer = null;
  }

  function arrive({ actor, tick, why, camera, view, ...rest }: Address): void {
    viewpoint.ask(camera);
    viewpoint.mode.value = view ?? "follow";
    if (actor !== null) selection.actor.value = actor;
    layer = rest.layer;
    // The session forgets the past of the stage before, first.
    queueMicrotask(() => {
      showLayer();
      if (tick !== null) playback.look(tick);
      if (why !== null) inspection.why.value = why;
    });
  }

  session.gone.on(() => {
    isLed = true;
    asked = null;
  });
  window.addEventListener("popstate", open);
  machine.info.subscribe(showLayer);
  stage.hello.subscribe((hello) => {
    if (!hello) return;
    if (asked && (asked.stage ?? "main") === hello.stage) arrive(asked);
    asked = null;
    const opening = stages.openingOf(hello.stage);
    const address = addressWith(shownAddress(state));
    const isSame = (readAddress().stage ?? "main") === hello.stage;
    if (isLed || isSame) history.replaceState(opening, "", address);
    else history.pushState(opening, "", address);
    isLed = false;
  });
  let timer: ReturnType<typeof setTimeout> | undefined;
  effect(() => {
    shownAddress(state);
    clearTimeout(timer);
    timer = setTimeout(() => {
      if (stage.id === stage.hello.value?.stage)
        history.replaceState(history.state, "", addressWith(shownAddress(state)));
    }, REST_MS);
  });
  open();
}
