/** Finds the states and arrows that the graph draws of a layer; one box stands for each folded sub-machine. */

import type { Edge, LayerInfo } from "../../net/protocol";
import { filtered } from "../../state/nameFilter";
import { MOST_STATES, statesToDraw } from "./neighbours";
import type { Places, Point } from "./shapes";

/** A state, or a folded sub-machine. */
export interface GraphNode {
  name: string;
  /** What it plays, in words. */
  facts: string;
  /** The states that are folded into it; none: it is a state. */
  inner: readonly string[];
}

export interface Content {
  nodes: readonly GraphNode[];
  edges: readonly Edge[];
  initial: string;
}

/** Returns a layer with a node for each folded sub-machine; `shown`: what stands for each state. */
export function folded(layer: LayerInfo, shown: ReadonlyMap<string, string>): Content {
  const standIn = (name: string): string => shown.get(name) ?? name;
  const names = new Set(layer.states.map(({ name }) => standIn(name)));
  const isWhole = layer.states.every(({ name }) => standIn(name) === name);
  return {
    nodes: [...names].map((name) => node(layer, name, standIn)),
    edges: isWhole ? layer.edges : merged(layer.edges, standIn),
    initial: standIn(layer.initial),
  };
}

/** Returns the part of a graph that the filter's words name; without words, of a large one the part around the live node. */
export function partOf({ nodes, edges, initial }: Content, live: string, words: string): Content {
  const all = nodes.map(({ name }) => name);
  const named = filtered(all, words);
  const isFiltered = named.length < all.length;
  const names = new Set(isFiltered ? named.slice(0, MOST_STATES) : statesToDraw(all, edges, live));
  return {
    nodes: nodes.filter(({ name }) => names.has(name)),
    edges: edges.filter(({ from, to }) => names.has(from) && names.has(to)),
    initial,
  };
}

/** Returns the places with one for each folded sub-machine: the middle of its states. */
export function withFolded(places: Places, nodes: readonly GraphNode[]): Places {
  const middles = nodes.flatMap(({ name, inner }): [string, Point][] => {
    const known = inner.flatMap((state) => places.get(state) ?? []);
    return known.length && !places.has(name) ? [[name, middle(known)]] : [];
  });
  return new Map([...places, ...middles]);
}

function node({ states }: LayerInfo, name: string, standIn: (name: string) => string): GraphNode {
  const info = states.find((state) => state.name === name);
  const inner = info ? [] : states.map((state) => state.name).filter((state) => standIn(state) === name);
  const length = info?.motion ? `${info.motion}, ${info.duration.toFixed(2)} s` : "no motion";
  return {
    name,
    inner,
    facts: info ? `${length}${info.motion && info.loop ? ", loops" : ""}` : inner.join(", "),
  };
}

/** Joins the arrows between the same nodes; those within a folded sub-machine are left out. */
function merged(edges: readonly Edge[], standIn: (name: string) => string): Edge[] {
  const joined = new Map<string, Edge>();
  for (const edge of edges) {
    const [from, to] = [standIn(edge.from), standIn(edge.to)];
    if (from === to && from !== edge.from) continue;
    const key = JSON.stringify([from, to]);
    const events = new Set([...(joined.get(key)?.events ?? []), ...edge.events]);
    joined.set(key, { from, to, events: [...events] });
  }
  return [...joined.values()];
}

function middle(points: readonly Point[]): Point {
  const mean = (values: readonly number[]): number =>
    Math.round(values.reduce((sum, value) => sum + value, 0) / values.length);
  return { x: mean(points.map(({ x }) => x)), y: mean(points.map(({ y }) => y)) };
}
