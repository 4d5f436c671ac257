// @vitest-environment happy-dom
import { beforeEach, expect, it } from "vitest";
import { backgroundOf, FIRST_LOOK, SceneSettings } from "./sceneSettings";

beforeEach(() => localStorage.clear());

it("keeps what is set for the next visit, and resets all of it", () => {
  new SceneSettings().set({ exposure: 2, shadow: false });
  const later = new SceneSettings();
  expect(later.look.value).toEqual({ ...FIRST_LOOK, exposure: 2, shadow: false });
  expect(later.isChanged.value).toBe(true);
  later.reset();
  expect([later.isChanged.value, new SceneSettings().look.value]).toEqual([false, FIRST_LOOK]);
});

it.each(["{", "7", '{"exposure":2}', JSON.stringify({ ...FIRST_LOOK, colour: "red;x" })])(
  "takes its own look in place of %s",
  (text) => {
    localStorage.setItem("statwalk.scene", text);
    expect(new SceneSettings().look.value).toEqual(FIRST_LOOK);
  },
);

it("a gradient darkens towards the edge, and the theme has its own colours", () => {
  const look = { ...FIRST_LOOK, colour: "#6414ff" };
  expect(backgroundOf(look)).toBeNull();
  expect(backgroundOf({ ...look, background: "colour" })).toEqual(["#6414ff", "#6414ff"]);
  expect(backgroundOf({ ...look, background: "gradient" })).toEqual(["#6414ff", "#2d0973"]);
});
