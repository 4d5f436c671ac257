import { describe, expect, it } from "vitest";
import { chooseQuality } from "./quality";

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
