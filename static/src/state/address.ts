/** Keeps the stage's name in the address, so that you can reload and share it, and what it began with. */

import type { OwnStages } from "./ownStages";
import type { WatchedStage } from "./watchedStage";

/** Returns the stage that the address names, or null. */
export function stageOfAddress(): string | null {
  return new URLSearchParams(location.search).get("stage");
}

export function keepAddress(stage: WatchedStage, stages: OwnStages): void {
  stage.hello.subscribe((hello) => {
    if (!hello) return;
    const address = new URL(location.href);
    if (hello.stage === "main") address.searchParams.delete("stage");
    else address.searchParams.set("stage", hello.stage);
    history.replaceState(stages.openingOf(hello.stage), "", address);
  });
}
