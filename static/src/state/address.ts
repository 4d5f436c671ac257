/**
 * Keeps the stage's name in the address, so that you can reload and share it, and what it began with. Another stage
 * is another page of the browser's history: Back and Forward lead to the stages that you watched.
 */

import type { OwnStages } from "./ownStages";
import type { Session } from "./session";
import type { WatchedStage } from "./watchedStage";

/** Returns the stage that the address names, or null. */
export function stageOfAddress(): string | null {
  return new URLSearchParams(location.search).get("stage");
}

/** Returns the address of the page at a stage. */
export function addressOf(stage: string): URL {
  const address = new URL(location.href);
  if (stage === "main") address.searchParams.delete("stage");
  else address.searchParams.set("stage", stage);
  return address;
}

export function keepAddress(stage: WatchedStage, stages: OwnStages, session: Session): void {
  // You did not choose the next stage now: the address did, or the server.
  let isLed = true;
  session.gone.on(() => (isLed = true));
  window.addEventListener("popstate", () => {
    isLed = true;
    void stages.begin(stageOfAddress());
  });
  stage.hello.subscribe((hello) => {
    if (!hello) return;
    const address = addressOf(hello.stage);
    const opening = stages.openingOf(hello.stage);
    if (isLed || address.href === location.href) history.replaceState(opening, "", address);
    else history.pushState(opening, "", address);
    isLed = false;
  });
}
