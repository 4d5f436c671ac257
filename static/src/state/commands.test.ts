// @vitest-environment happy-dom
import { beforeEach, expect, it } from "vitest";
import { Commands, keyName } from "./commands";

function two(): Commands {
  const commands = new Commands();
  commands.add({ words: "frame", keys: ["f"], act: () => {} }, { words: "turn", keys: ["r"], act: () => {} });
  return commands;
}

beforeEach(() => localStorage.clear());

it("a changed key is kept for the next visit", () => {
  expect(two().rebind("frame", "q")).toBeNull();
  const next = two();
  expect([next.of("q")?.words, next.of("f")]).toEqual(["frame", undefined]);
});

it("a key of another command is refused, and the command is named", () => {
  const commands = two();
  expect(commands.rebind("frame", "r")).toBe("R is already the key of “turn”");
  expect(commands.of("f")?.words).toBe("frame");
});

it.each(["Tab", "Escape", "ctrl+Enter"])("%s stays free", (key) => {
  expect(two().rebind("frame", key)).toContain("can't be a command's key");
});

it("reset brings back the first keys", () => {
  const commands = two();
  commands.rebind("frame", "q");
  commands.reset();
  expect([commands.of("f")?.words, two().areChanged.value]).toEqual(["frame", false]);
});

it.each(["not JSON", "3", '{"frame": "q"}'])("what is no list of keys is ignored: %s", (text) => {
  localStorage.setItem("statwalk.keys", text);
  expect(two().of("f")?.words).toBe("frame");
});

it("Ctrl and the Mac's command key are one", () => {
  const press = { key: "K", ctrlKey: false, metaKey: true };
  expect(keyName(press)).toBe("ctrl+k");
});
