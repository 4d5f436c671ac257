import { expect, it } from "vitest";
import type { Viewer } from "../../net/protocol";
import { nameOfViewer, placeWords } from "./viewerWords";

const viewer: Viewer = {
  ...{ id: 3, name: "", person: "", role: "view", actor: null, tick: null, follows: null },
};

it("calls a viewer by its own name, its token's person, or its number", () => {
  expect(nameOfViewer(viewer)).toBe("viewer 3");
  expect(nameOfViewer({ ...viewer, person: "ada" })).toBe("ada");
  expect(nameOfViewer({ ...viewer, name: "Countess", person: "ada" })).toBe("Countess (ada)");
});

it("says what a viewer looks at", () => {
  const ada = { ...viewer, id: 4, name: "Ada" };
  const looking = { ...viewer, actor: 1, tick: 90, follows: 4 };
  expect(placeWords(looking, [{ id: 1, name: "walker" }], [looking, ada])).toBe(
    "looks at walker · at tick 90 · follows Ada",
  );
});
