/**
 * Builds the page's elements. Names come from files of strangers, so they are set as text, never as markup.
 */

type Attributes = Record<string, string | number | boolean | undefined>;
type Child = Node | string | null;

function set(element: Element, attributes: Attributes, children: readonly Child[]): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== undefined && value !== false)
      element.setAttribute(name, value === true ? "" : String(value));
  }
  element.append(...children.filter((child): child is Node | string => child !== null));
}

/** Makes an HTML element; attributes by name, `class` too. */
export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  set(element, attributes, children);
  return element;
}

/** Makes an SVG element. */
export function svg<K extends keyof SVGElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): SVGElementTagNameMap[K] {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  set(element, attributes, children);
  return element;
}

/** Returns the element with this id; throws if the page has none. */
export function byId(id: string): HTMLElement {
  const element = document.getElementById(id);
  if (!element) throw new Error(`the page has no #${id}`);
  return element;
}

/** Returns the canvas with this id; throws if the page has none. */
export function canvasById(id: string): HTMLCanvasElement {
  const element = byId(id);
  if (!(element instanceof HTMLCanvasElement)) throw new Error(`#${id} is no canvas`);
  return element;
}

/** Sets the text if it differs: the same text again would cost a layout. */
export function say(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

/** Returns the present value of one of the page's CSS custom properties. */
export function token(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

export function reducedMotion(): boolean {
  return window.matchMedia("(prefers-reduced-motion: reduce)").matches;
}

/** Calls `change` now and when the system turns dark or light. */
export function onTheme(change: () => void): void {
  change();
  window
    .matchMedia("(prefers-color-scheme: dark)")
    .addEventListener("change", () => requestAnimationFrame(change));
}

/** Restarts the CSS animation `name` on an element. */
export function flash(element: Element, name: string): void {
  element.classList.remove(name);
  void (element as HTMLElement).getBoundingClientRect();
  element.classList.add(name);
}
