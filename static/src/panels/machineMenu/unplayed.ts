/** Leaves the stage of a machine that shall be renamed or deleted: a machine on a stage can't be. */

import * as machines from "../../net/machines";
import type { App } from "../../view/app";

/**
 * Leaves the stage, then renames or deletes the machine that it plays (`act`). Stays if the server would refuse: a
 * stage of this page is closed as the page leaves it.
 */
export async function unplayed(app: App, machine: string, act: () => Promise<unknown>): Promise<void> {
  const { id } = app.stage;
  await machines.checkUnused(machine, id);
  await leave(app);
  try {
    await act();
  } catch (refused) {
    app.session.watch(id);
    throw refused;
  }
}

/** Watches the main stage, and waits until it is there: a machine on a stage can't be renamed or deleted. */
async function leave({ session, stage, stages, editing }: App): Promise<void> {
  editing.abandon();
  if (stage.id === "main") return;
  session.watch("main");
  await new Promise<void>((done) => {
    const end = stage.hello.subscribe((hello) => {
      if (hello?.stage !== "main") return;
      queueMicrotask(() => end());
      done();
    });
  });
  await stages.closed;
}
