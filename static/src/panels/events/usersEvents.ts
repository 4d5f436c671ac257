/** Which events of a machine are the user's. */

import type { MachineInfo } from "../../net/protocol";

/** Returns the events but for those that motions raise: their ends, and markers to which no key is bound. */
export function usersEvents({ events, keys, states, layers }: MachineInfo): string[] {
  const all = [...states, ...layers.flatMap((layer) => layer.states)];
  const markers = new Set(all.flatMap((state) => state.markers.map(({ name }) => name)));
  const bound = new Set(Object.values(keys).flatMap(({ press, release }) => [press, release]));
  return events.filter((event) => event !== "END" && (!markers.has(event) || bound.has(event)));
}
