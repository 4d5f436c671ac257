/** Which events of a machine are the user's. */

import type { MachineInfo } from "../../net/protocol";

/** Returns the events that a user raises: all but END and the markers of motions. A marker that has a key is a user's event. */
export function usersEvents({ events, keys, states, layers }: MachineInfo): string[] {
  const all = [...states, ...layers.flatMap((layer) => layer.states)];
  const markers = new Set(all.flatMap((state) => state.markers.map(({ name }) => name)));
  const bound = new Set(Object.values(keys).flatMap(({ press, release }) => [press, release]));
  return events.filter((event) => event !== "END" && (!markers.has(event) || bound.has(event)));
}
