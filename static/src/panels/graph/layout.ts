/** Places the states of a graph: dagre's layers in the direction that fits the panel best, or a ring. */

import * as dagre from "@dagrejs/dagre";
import type { Edge } from "../../net/protocol";
import { isDense, ringPlan } from "./ringLayout";
import { type Places, type Plan, type Point, type Size, STATE_HEIGHT, stateWidth } from "./shapes";

interface Way {
  rankdir: "TB" | "LR";
  ranker: "network-simplex" | "tight-tree" | "longest-path";
}

const WAYS: readonly Way[] = (["TB", "LR"] as const).flatMap((rankdir) =>
  (["network-simplex", "tight-tree", "longest-path"] as const).map((ranker) => ({ rankdir, ranker })),
);
/** Above it only one way is tried: each takes its time. */
const MANY_EDGES = 300;
const MOST_STRETCH = 2.2;
/** Layers that would be drawn smaller than that give way to a ring that would be so much larger. */
const [LEAST_SCALE, RING_GAIN] = [0.7, 1.3];
/** The most states on such a ring, and the height of a panel in whose corner the graph's buttons cover none of them. */
const [MOST_ON_RING, RING_HEIGHT] = [16, 160];
/** Of a panel, how much the states fill: arrows bend outwards. */
const FILLED = 0.92;

function layered(states: readonly string[], edges: readonly Edge[], { rankdir, ranker }: Way): Plan {
  const graph = new dagre.graphlib.Graph();
  const [nodesep, ranksep] = rankdir === "TB" ? [22, 34] : [18, 44];
  graph.setGraph({ rankdir, ranker, nodesep, ranksep, edgesep: 8, marginx: 14, marginy: 18 });
  graph.setDefaultEdgeLabel(() => ({}));
  for (const name of states) graph.setNode(name, { width: stateWidth(name), height: STATE_HEIGHT });
  for (const { from, to } of edges) if (from !== to) graph.setEdge(from, to);
  dagre.layout(graph);
  const places = states.map((name): [string, Point] => {
    const { x, y } = graph.node(name) as Point;
    return [name, { x, y }];
  });
  const { width = 0, height = 0 } = graph.graph() as { width?: number; height?: number };
  return { width, height, places: new Map(places) };
}

/** Returns how large a plan appears in a panel, if all of it is seen. */
const scale = ({ width, height }: Size, room: Size): number =>
  Math.min(room.width / Math.max(width, 1), room.height / Math.max(height, 1));

/** Moves the states apart to fill a panel, which gives labels room; places are whole, as the file keeps them. */
function stretched(found: Plan, room: Size): Places {
  const zoom = Math.min(1, scale(found, room));
  const apart = (free: number, taken: number): number =>
    Math.min(MOST_STRETCH, Math.max(1, (free * FILLED) / zoom / Math.max(taken, 1)));
  const [wide, high] = [apart(room.width, found.width), apart(room.height, found.height)];
  return new Map(
    [...found.places].map(([name, { x, y }]) => [name, { x: Math.round(x * wide), y: Math.round(y * high) }]),
  );
}

/** Returns the places that appear largest in a panel of this size. Edges to unknown states are left out. */
export function layOut(states: readonly string[], edges: readonly Edge[], room: Size): Places {
  const known = new Set(states);
  const drawable = edges.filter(({ from, to }) => known.has(from) && known.has(to));
  const ring = ringPlan(states, room);
  if (isDense(states.length, drawable.length)) return stretched(ring, room);
  const plans = WAYS.slice(0, drawable.length > MANY_EDGES ? 1 : undefined).map((way) =>
    layered(states, drawable, way),
  );
  const best = plans.reduce((one, next) => (scale(next, room) > scale(one, room) * 1.02 ? next : one));
  const mayRing =
    states.length <= MOST_ON_RING && room.height >= RING_HEIGHT && scale(best, room) < LEAST_SCALE;
  return stretched(mayRing && scale(ring, room) > scale(best, room) * RING_GAIN ? ring : best, room);
}
