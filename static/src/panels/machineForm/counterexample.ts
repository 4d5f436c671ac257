/** Shows what refutes a property: a stage of its own, with the inputs of the verifier's counterexample. */

import * as actors from "../../net/actors";
import * as api from "../../net/api";
import type { Finding } from "../../net/protocol";
import type { App } from "../../view/app";

/** Ticks after the violation, so that one sees what follows. */
const AFTERWARDS = 30;
/** The longest name that a stage may have. */
const LONGEST_NAME = 80;

/** Plays a counterexample on a new stage, and shows it from its first tick. */
export async function playCounterexample(app: App, machine: string, finding: Finding): Promise<void> {
  const { session, stages } = app;
  await session.command(async () => {
    const name = `against: ${finding.message}`.slice(0, LONGEST_NAME);
    const { id, actors: cast } = await api.manualStage(machine, name);
    await send(id, cast[0]!.id, finding);
    stages.show(id, { machine });
    replayFromStart(app, id);
  });
}

/** Sends each input so that it counts in its tick. */
async function send(stage: string, actor: number, { replay, ticks }: Finding): Promise<void> {
  let head = 0;
  for (const [tick, event] of replay) {
    if (tick - 1 > head) await api.step(stage, tick - 1 - head);
    head = Math.max(head, tick - 1);
    await actors.sendEvent(stage, actor, event);
  }
  await api.step(stage, ticks - head + AFTERWARDS);
}

/** Looks at the first tick and plays on from there, as soon as the stage is shown. */
function replayFromStart({ stage, playback }: App, id: string): void {
  const end = stage.hello.subscribe((hello) => {
    if (hello?.stage !== id) return;
    // After the greeting, which lets go of the past.
    queueMicrotask(() => {
      end();
      playback.look(0);
      playback.toggle();
    });
  });
}
