/** Places the states of a graph: dagre's layout in the direction that fits the panel best, or a ring for dense graphs. */

import * as dagre from "@dagrejs/dagre";
import type { Edge } from "../../net/protocol";
import { isDense, ringPlaces } from "./ringLayout";
import { type Point, STATE_HEIGHT, stateWidth } from "./shapes";

/** Where each state stands. */
export type Places = Map<string, Point>;

interface Plan {
  width: number;
  height: number;
  places: Places;
}

interface Way {
  rankdir: "TB" | "LR";
  ranker: "network-simplex" | "tight-tree" | "longest-path";
}

const WAYS: readonly Way[] = (["TB", "LR"] as const).flatMap((rankdir) =>
  (["network-simplex", "tight-tree", "longest-path"] as const).map((ranker) => ({ rankdir, ranker })),
);
/** Above it only one way is tried: each takes its time. */
const MANY_EDGES = 300;
const MOST_STRETCH = 2;

function plan(states: readonly string[], edges: readonly Edge[], { rankdir, ranker }: Way): Plan {
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

/** Moves the states apart to fill `aspect`; places are whole, as the file keeps them. */
function stretched({ width, height, places }: Plan, aspect: number): Places {
  const wide = Math.min(MOST_STRETCH, Math.max(1, (height * aspect) / Math.max(width, 1)));
  const high = Math.min(MOST_STRETCH, Math.max(1, width / aspect / Math.max(height, 1)));
  return new Map(
    [...places].map(([name, { x, y }]) => [name, { x: Math.round(x * wide), y: Math.round(y * high) }]),
  );
}

/**
 * Returns the places that appear largest in a panel of `aspect` (width over height). Edges to unknown states are
 * left out.
 */
export function layOut(states: readonly string[], edges: readonly Edge[], aspect: number): Places {
  const known = new Set(states);
  const drawable = edges.filter(({ from, to }) => known.has(from) && known.has(to));
  if (isDense(states.length, drawable.length)) return ringPlaces(states, aspect);
  const plans = WAYS.slice(0, drawable.length > MANY_EDGES ? 1 : undefined).map((way) =>
    plan(states, drawable, way),
  );
  const scale = ({ width, height }: Plan): number =>
    Math.min(aspect / Math.max(width, 1), 1 / Math.max(height, 1));
  return stretched(
    plans.reduce((best, next) => (scale(next) > scale(best) * 1.02 ? next : best)),
    aspect,
  );
}
