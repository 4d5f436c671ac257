/**
 * Lays out the state graph: dagre's layout in the direction that fits the panel best, or a ring for dense
 * graphs.
 */

import * as dagre from "@dagrejs/dagre";
import type { Edge } from "../../net/protocol";
import { isDense, ringLayout } from "./ringLayout";
import {
  type Layout,
  type PlacedEdge,
  type PlacedState,
  type Point,
  STATE_HEIGHT,
  borderPoint,
  curve,
  selfLoop,
  stateWidth,
} from "./shapes";

/** dagre's result, before the edges are drawn. */
interface Plan {
  width: number;
  height: number;
  states: PlacedState[];
  edges: readonly Edge[];
  routes: Point[][];
}

interface Way {
  rankdir: "TB" | "LR";
  ranker: "network-simplex" | "tight-tree" | "longest-path";
}

const WAYS: readonly Way[] = (["TB", "LR"] as const).flatMap((rankdir) =>
  (["network-simplex", "tight-tree", "longest-path"] as const).map((ranker) => ({ rankdir, ranker })),
);

function layOut(states: readonly string[], edges: readonly Edge[], { rankdir, ranker }: Way): Plan {
  const graph = new dagre.graphlib.Graph();
  graph.setGraph({
    rankdir,
    ranker,
    nodesep: rankdir === "TB" ? 18 : 14,
    ranksep: rankdir === "TB" ? 26 : 24,
    edgesep: 8,
    marginx: 14,
    marginy: 18,
  });
  graph.setDefaultEdgeLabel(() => ({}));
  for (const name of states) graph.setNode(name, { width: stateWidth(name), height: STATE_HEIGHT });
  for (const { from, to } of edges) if (from !== to) graph.setEdge(from, to);
  dagre.layout(graph);
  const placed = states.map((name) => {
    const { x, y } = graph.node(name) as Point;
    return { name, x, y, width: stateWidth(name) };
  });
  const { width = 0, height = 0 } = graph.graph() as { width?: number; height?: number };
  const routes = edges.map(({ from, to }) =>
    from === to ? [] : (graph.edge(from, to) as { points: Point[] }).points,
  );
  return { width, height, states: placed, edges, routes };
}

const MOST_STRETCH = 2;

/** Moves the states apart to fill `aspect`, keeps the boxes' size, and draws the edges. */
function stretch({ width, height, states, edges, routes }: Plan, aspect: number): Layout {
  const wide = Math.min(MOST_STRETCH, Math.max(1, (height * aspect) / Math.max(width, 1)));
  const high = Math.min(MOST_STRETCH, Math.max(1, width / aspect / Math.max(height, 1)));
  const move = <T extends Point>(point: T): T => ({ ...point, x: point.x * wide, y: point.y * high });
  const placed = states.map(move);
  const where = new Map(placed.map((state) => [state.name, state]));
  const drawn = edges.map((edge, i) => ({
    ...edge,
    ...(edge.from === edge.to
      ? selfLoop(where.get(edge.from)!)
      : route(routes[i]!.map(move), where.get(edge.from)!, where.get(edge.to)!)),
  }));
  return { width: width * wide, height: height * high, states: placed, edges: drawn, dense: false };
}

/** Draws an edge along `points` from box to box. */
function route(
  points: readonly Point[],
  from: PlacedState,
  to: PlacedState,
): Pick<PlacedEdge, "path" | "x" | "y"> {
  const inner = points.slice(1, -1);
  const ends = [borderPoint(from, inner[0] ?? to), borderPoint(to, inner.at(-1) ?? from)] as const;
  const middle = inner[Math.floor(inner.length / 2)] ?? { x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 };
  return { path: curve([ends[0], ...inner, ends[1]]), x: middle.x, y: middle.y };
}

/**
 * Returns the layout that appears largest in a panel of `aspect` (width over height). Edges to unknown states
 * are left out.
 */
export function layoutGraph(states: readonly string[], edges: readonly Edge[], aspect: number): Layout {
  const known = new Set(states);
  const drawable = edges.filter(({ from, to }) => known.has(from) && known.has(to));
  if (isDense(states.length, drawable.length)) return ringLayout(states, drawable, aspect);
  const candidates = WAYS.map((way) => layOut(states, drawable, way));
  const scale = ({ width, height }: Plan): number =>
    Math.min(aspect / Math.max(width, 1), 1 / Math.max(height, 1));
  return stretch(
    candidates.reduce((best, next) => (scale(next) > scale(best) * 1.02 ? next : best)),
    aspect,
  );
}
