import { expect, it } from "vitest";
import { cast, hello } from "../net/types/examples";
import { WatchedStage } from "./watchedStage";

const among = (...ids: number[]) => cast({ actors: ids.map((id) => ({ id, name: `actor ${id}` })) });

it("knows the actor that came first, whatever its cast", () => {
  const stage = new WatchedStage();
  expect(stage.firstActor).toBeNull();
  stage.greet(hello({ casts: [among(8, 9), among(3, 1)] }));
  expect(stage.firstActor).toBe(1);
});
