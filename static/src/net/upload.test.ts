import { describe, expect, it } from "vitest";
import { nameFor, takenNames } from "./upload";

describe("nameFor", () => {
  const none = new Set<string>();

  it("is the file's name without its ending", () => {
    expect(nameFor("RobotExpressive.glb", none)).toBe("RobotExpressive");
  });

  it("keeps what the server takes", () => {
    expect(nameFor("Café Robot (2).v3.glb", none)).toBe("Cafe-Robot-2-v3");
  });

  it("never leads elsewhere, and is never empty", () => {
    expect(["../../x.glb", ".glb", "机器人.zip", "<img>.glb"].map((file) => nameFor(file, none))).toEqual([
      "x",
      "character",
      "character",
      "img",
    ]);
  });

  it("counts where the name is in use", () => {
    expect(nameFor("fox.glb", new Set(["fox", "fox-2"]))).toBe("fox-3");
  });

  it("stays short", () => {
    expect(nameFor(`${"x".repeat(300)}.glb`, none).length).toBeLessThanOrEqual(60);
  });
});

describe("takenNames", () => {
  it("leaves out an upload that no machine was made of", () => {
    const upload = { uploaded: true as const, sha256: "", bytes: 0, machines: [] };
    const characters = [
      { name: "walker", machine: "faq-walker", uploaded: false as const },
      { ...upload, name: "fox", machine: "fox" },
      { ...upload, name: "left", machine: null },
    ];
    expect([...takenNames([{ name: "faq-walker" }], characters)]).toEqual(["faq-walker", "walker", "fox"]);
  });
});
