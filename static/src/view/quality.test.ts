import { describe, expect, it } from "vitest";
import { chooseQuality, leastStep_s } from "./quality";

const SWIFTSHADER =
  "ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero) (0x0000C0DE)), SwiftShader driver)";

describe("chooseQuality", () => {
  it.each([
    [SWIFTSHADER, "", "low"],
    ["llvmpipe (LLVM 15.0.6, 256 bits)", "", "low"],
    ["ANGLE (Apple, ANGLE Metal Renderer: Apple M2, Unspecified Version)", "", "high"],
    [SWIFTSHADER, "?quality=high", "high"],
    ["GeForce", "?stage=main&quality=low", "low"],
    ["GeForce", "?quality=ultra", "high"],
  ])("%s with %j is %s", (name, search, expected) => {
    expect(chooseQuality(name, search)).toBe(expected);
  });
});

describe("leastStep_s", () => {
  it.each([
    ["low", "", 30],
    ["low", "?fps=10", 10],
    ["low", "?fps=60", 30],
    ["high", "?stage=main&fps=60", 60],
    ["low", "?fps=-1", 30],
    ["low", "?fps=fast", 30],
  ] as const)("%s with %j is for %d drawings a second", (quality, search, fps) => {
    expect(1 / leastStep_s(quality, search)).toBeCloseTo(fps / 0.9);
  });

  it("lets a graphics card draw as often as the browser does", () => {
    expect(leastStep_s("high", "?fps=")).toBe(0);
  });
});
