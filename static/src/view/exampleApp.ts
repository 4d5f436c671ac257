/** For tests of panels: the page's own state, without a server, and a view without a picture. */

import { signal } from "@preact/signals-core";
import { vi } from "vitest";
import { Meter } from "../net/meter";
import { cast, hello, machine } from "../net/types/examples";
import type { CastHello, MachineInfo } from "../net/protocol";
import { makeState } from "../state/state";
import type { App } from "./app";
import type { StageView } from "./stageView";

/** Returns the parts of a view that panels without a picture read. */
function viewAlone(): StageView {
  return { drawn: new Meter(), loading: signal("") } as unknown as StageView;
}

export function exampleApp(): App {
  vi.stubGlobal("fetch", () => Promise.reject(new TypeError("there is no server")));
  return { ...makeState(), view: viewAlone() };
}

/** Watches an actor of a machine, as after the server's hello and its answer. */
export function watch(
  { stage, selection, machine: watched }: App,
  info: Partial<MachineInfo>,
  members: Partial<CastHello> = {},
): void {
  const known = machine(info);
  const actors = [{ id: 1, name: "one" }];
  stage.greet(hello({ casts: [cast({ machine: known.name, actors, ...members })] }));
  selection.settle();
  watched.take(known);
}
