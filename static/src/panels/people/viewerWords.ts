/** Says who a viewer is and what it looks at. */

import type { ActorName, Viewer } from "../../net/protocol";

export const RIGHTS = {
  view: "may look",
  drive: "may drive",
  admin: "may change everything",
} satisfies Record<Viewer["role"], string>;

/** Returns what a viewer says it is called, with the person whose token it has. */
export function nameOfViewer({ id, name, person }: Viewer): string {
  const own = name || person || `viewer ${id}`;
  return person && person !== own ? `${own} (${person})` : own;
}

/** Says which actor and which time a viewer looks at, and whom it follows. */
export function placeWords(
  { actor, tick, follows }: Viewer,
  actors: readonly ActorName[],
  viewers: readonly Viewer[],
): string {
  const looked = actors.find(({ id }) => id === actor);
  const followed = viewers.find(({ id }) => id === follows);
  return [
    looked && `looks at ${looked.name}`,
    tick === null ? "live" : `at tick ${tick}`,
    followed && `follows ${nameOfViewer(followed)}`,
  ]
    .filter(Boolean)
    .join(" · ");
}
