/** Makes the SVG elements of states and arrows. */

import { svg } from "../../ui/dom";
import type { GraphNode } from "./content";
import { type Label, labelText } from "./labels";
import { type Arrow, type Box, STATE_HEIGHT, pointAt, shortName, svgPath } from "./shapes";

const ROUND = 8;
/** Radius of the dot from which an arrow is drawn. */
const DOT = 5;
/** How far the box behind that of a folded sub-machine stands out. */
const STACK = 4;

export function arrowHead(): SVGElement {
  const tip = svg("path", { d: "M0 0L8 4L0 8Z" });
  const size = {
    viewBox: "0 0 8 8",
    refX: 7,
    refY: 4,
    markerWidth: 8,
    markerHeight: 8,
    markerUnits: "userSpaceOnUse",
  };
  return svg("defs", {}, svg("marker", { id: "arrow", class: "tip", orient: "auto", ...size }, tip));
}

const boxShape = (width: number): Record<string, number> => ({
  x: -width / 2,
  y: -STATE_HEIGHT / 2,
  width,
  height: STATE_HEIGHT,
  rx: ROUND,
});

/** Draws the invisible rim by which a pointer hits a state that is drawn small. */
export function drawHalo({ name, width }: Box): SVGElement {
  return svg("rect", { class: "halo", "data-state": name, ...boxShape(width) });
}

/** Draws a state with its rim and dot, from which arrows are drawn; or a folded sub-machine. */
export function drawState({ name, width }: Box, { facts, inner }: GraphNode, initial: boolean): SVGGElement {
  const isFolded = inner.length > 0;
  const kind = isFolded ? "folded sub-machine" : "state";
  const help = isFolded ? "double click: unfold" : "double click: go there; drag its rim: a new arrow";
  const shape = boxShape(width);
  const behind = { ...shape, x: shape["x"]! + STACK, y: shape["y"]! + STACK };
  return svg(
    "g",
    {
      class: ["state", initial ? "initial" : "", isFolded ? "folded" : ""].filter(Boolean).join(" "),
      "data-state": name,
      role: "button",
      tabindex: -1,
      "aria-label": initial ? `${kind} ${name}, the first` : `${kind} ${name}`,
    },
    svg("title", {}, `${name}: ${facts}; ${help}`),
    isFolded ? svg("rect", { class: "box behind", ...behind }) : null,
    svg("rect", { class: "box", ...shape }),
    svg("text", { y: 4, "text-anchor": "middle" }, shortName(name)),
    isFolded ? null : svg("rect", { class: "rim", ...shape }),
    isFolded ? null : svg("circle", { class: "rim dot", cx: width / 2, r: DOT }),
  );
}

export function placeState(part: SVGElement, { x, y }: Box): void {
  part.setAttribute("transform", `translate(${x.toFixed(1)} ${y.toFixed(1)})`);
}

export function drawArrow(arrow: Arrow): SVGGElement {
  const atEnd = arrow.events.every((event) => event === "END");
  const says = `${arrow.from} to ${arrow.to}: ${arrow.events.join(", ")}`;
  return svg(
    "g",
    {
      class: atEnd ? "edge at-end" : "edge",
      "data-from": arrow.from,
      "data-to": arrow.to,
      "data-events": arrow.events.join(),
      role: "button",
      tabindex: -1,
      "aria-label": `arrow from ${says}`,
    },
    svg("title", {}, says),
    svg("path", { class: "reach" }),
    svg("path", { class: "line" }),
    svg("text", { "text-anchor": "middle", dy: "0.35em" }),
  );
}

export function bendArrow(group: SVGGElement, arrow: Arrow): void {
  const path = svgPath(arrow.curve);
  for (const line of group.querySelectorAll("path")) line.setAttribute("d", path);
}

/** Writes an arrow's label; `null`: in the middle of the arrow, and only while somebody points at it. */
export function writeLabel(group: SVGGElement, arrow: Arrow, label: Label | null): void {
  const text = group.querySelector("text")!;
  const shown = label ?? { ...pointAt(arrow.curve, 0.5), events: arrow.events.slice(0, 1), more: 0 };
  const more = label ? label.more : arrow.events.length - 1;
  group.classList.toggle("squeezed", label === null);
  text.setAttribute("x", shown.x.toFixed(1));
  text.setAttribute("y", shown.y.toFixed(1));
  if (text.textContent === labelText({ events: shown.events, more })) return;
  text.replaceChildren(
    ...shown.events.flatMap((event, i) => [
      ...(i ? [document.createTextNode(", ")] : []),
      svg("tspan", { "data-label": event }, event),
    ]),
    ...(more ? [document.createTextNode(` +${more}`)] : []),
  );
}
