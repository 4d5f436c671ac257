import { expect, test } from "vitest";

/**
 * The floors of the viewer, lowest first: a file imports from its own folder and from lower floors. Folders
 * of one floor do not see each other.
 */
const FLOORS: readonly (readonly string[])[] = [
  ["net", "ui", "style"],
  ["state"],
  ["view"],
  ["panels"],
  [""],
];

const SOURCES = import.meta.glob<string>("./**/*.ts", { query: "?raw", import: "default", eager: true });
const IMPORT = /(?:from|import|new URL\()\s*\(?"(\.{1,2}\/[^"]+)"/g;

/** `./panels/table/table.ts` and `../../ui/dom` -> `ui/dom`. */
function resolved(file: string, target: string): string {
  return new URL(target, `file:///${file.slice(2)}`).pathname.slice(1).replace(/\.ts$/, "");
}

/** What each file of `sources` imports; tests are left out. */
function importsOf(sources: Record<string, string>): Map<string, string[]> {
  const files = Object.entries(sources).filter(([file]) => !file.endsWith(".test.ts"));
  return new Map(
    files.map(([file, text]) => [
      file.slice(2).replace(/\.ts$/, ""),
      [...text.matchAll(IMPORT)].map(([, target]) => resolved(file, target!)),
    ]),
  );
}

const topFolder = (file: string): string => (file.includes("/") ? file.slice(0, file.indexOf("/")) : "");
const folder = (file: string): string => file.slice(0, Math.max(0, file.lastIndexOf("/")));
const floor = (file: string): number => FLOORS.findIndex((folders) => folders.includes(topFolder(file)));

/** Imports that do not point down: `view/model -> panels/table/table`. */
function upward(imports: Map<string, string[]>): string[] {
  const allowed = (from: string, to: string): boolean =>
    floor(to) < floor(from) ||
    (topFolder(from) === "panels" ? folder(from) === folder(to) : topFolder(from) === topFolder(to));
  return [...imports].flatMap(([from, targets]) =>
    targets.filter((to) => floor(to) < 0 || !allowed(from, to)).map((to) => `${from} -> ${to}`),
  );
}

/** The first circle of imports that is found, as a list of its files, or an empty one. */
function circle(imports: Map<string, string[]>): string[] {
  const done = new Set<string>();
  const visit = (file: string, path: readonly string[]): string[] => {
    if (path.includes(file)) return [...path.slice(path.indexOf(file)), file];
    if (done.has(file)) return [];
    const below = (imports.get(file) ?? [])
      .map((next) => visit(next, [...path, file]))
      .find((found) => found.length);
    done.add(file);
    return below ?? [];
  };
  return [...imports.keys()].map((file) => visit(file, [])).find((found) => found.length) ?? [];
}

test("imports point down", () => {
  expect(upward(importsOf(SOURCES))).toEqual([]);
});

test("imports form no circle", () => {
  expect(circle(importsOf(SOURCES))).toEqual([]);
});

test("every file stands on a floor", () => {
  expect([...importsOf(SOURCES).keys()].filter((file) => floor(file) < 0)).toEqual([]);
});

/** The panels that each folder of `panels` exports; `curves` belongs to a page of its own. */
function panelsByFolder(): Map<string, string[]> {
  const found = new Map<string, string[]>();
  for (const [file, text] of Object.entries(SOURCES)) {
    const name = /^\.\/panels\/(?!curves\/)([^/]+)\//.exec(file)?.[1];
    const panels = [...text.matchAll(/^export function (\w+Panel)\(/gm)].map(([, panel]) => panel!);
    if (name) found.set(name, [...(found.get(name) ?? []), ...panels]);
  }
  return found;
}

test("each folder of panels exports one panel, which main.ts lists", () => {
  const listed = SOURCES["./main.ts"]!;
  for (const [name, panels] of panelsByFolder()) {
    expect(panels, name).toHaveLength(1);
    expect(listed).toContain(`", ${panels[0]!}],`);
  }
});

test("an import that points up, one between panels and a circle are seen", () => {
  const wrong = importsOf({
    "./view/model.ts": 'import type { A } from "../panels/table/table";',
    "./panels/table/table.ts": 'import { B } from "../why/words";\nimport "./table.css";',
    "./panels/why/words.ts": 'import { C } from "./why";',
    "./panels/why/why.ts": 'export { D } from "./words";',
  });
  expect(upward(wrong)).toEqual([
    "view/model -> panels/table/table",
    "panels/table/table -> panels/why/words",
  ]);
  expect(circle(wrong)).toEqual(["panels/why/words", "panels/why/why", "panels/why/words"]);
});

const STYLES = import.meta.glob<string>("./**/*.css", { query: "?raw", import: "default", eager: true });
/** Properties whose lengths and times are tokens. */
const SCALED =
  /^\s*(?:gap|padding[a-z-]*|margin[a-z-]*|font|font-size|border-radius|transition|animation): [^;]*;/gm;
/** Hairlines, and lengths of things that are larger than the scale, are none. */
const RAW = /(?<![\w.])(?:[2-9]|[12]\d|3[0-2])(?:\.\d+)?px|\d+ms/;

/** Declarations of a style with a length or a time of their own. */
const rawIn = (style: string): string[] =>
  [...style.matchAll(SCALED)].map(([text]) => text.trim()).filter((text) => RAW.test(text));

test("space, type, radius and motion are tokens", () => {
  const found = Object.entries(STYLES).filter(([file]) => file !== "./style/tokens.css");
  expect(found.flatMap(([file, style]) => rawIn(style).map((text) => `${file}: ${text}`))).toEqual([]);
});

test("a length of its own is seen", () => {
  expect(rawIn(".a {\n  padding: 0 9px;\n  margin: var(--space-s);\n  width: 9px;\n}\n")).toEqual([
    "padding: 0 9px;",
  ]);
});

/** Classes that the styles of more than one panel begin a rule with; those of `ui` and `style` are for all panels. */
function shared(styles: Record<string, string>): string[] {
  const owners = new Map<string, Set<string>>();
  for (const [file, style] of Object.entries(styles)) {
    const owner = /^\.\/panels\/([^/]+)\//.exec(file)?.[1] ?? "";
    for (const [, name] of style.matchAll(/^\s*\.([\w-]+)/gm))
      owners.set(name!, (owners.get(name!) ?? new Set()).add(owner));
  }
  return [...owners].flatMap(([name, of]) => (of.size > 1 && !of.has("") ? [name] : []));
}

test("a class belongs to one panel", () => {
  expect(shared(STYLES)).toEqual([]);
});

test("a class of two panels is seen", () => {
  const styles = { "./panels/a/a.css": ".row {\n}\n.bar b {\n}", "./panels/b/b.css": ".row, .bar {\n}" };
  expect(shared({ ...styles, "./ui/bar.css": ".bar {\n}" })).toEqual(["row"]);
});
