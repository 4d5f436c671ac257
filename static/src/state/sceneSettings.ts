/** How this browser lights the stage, and what is behind it: kept for the next visit. */

import { computed, signal } from "@preact/signals-core";
import { keep, kept } from "./kept";

export type Background = "theme" | "colour" | "gradient";

export const BACKGROUNDS: readonly Background[] = ["theme", "colour", "gradient"];

export interface SceneLook {
  /** The strength of the light from all around; 1 is the page's own. */
  environment: number;
  /** How much light the camera takes in; 1 is the page's own. */
  exposure: number;
  shadow: boolean;
  background: Background;
  /** Of a background that is not the theme's, as `#rrggbb`. */
  colour: string;
  /** Whether saved pictures have no background. */
  transparent: boolean;
}

export const FIRST_LOOK: SceneLook = {
  environment: 1,
  exposure: 1,
  shadow: true,
  background: "theme",
  colour: "#6f8fb5",
  transparent: false,
};

const PLACE = "statwalk.scene";
/** Of the colour, how much a gradient has at its edge. */
const EDGE = 0.45;

const isPositive = (value: unknown): boolean => typeof value === "number" && value >= 0 && value <= 10;

function isLook(value: unknown): value is SceneLook {
  if (typeof value !== "object" || value === null) return false;
  const { environment, exposure, shadow, background, colour, transparent } = value as SceneLook;
  return (
    isPositive(environment) &&
    isPositive(exposure) &&
    typeof shadow === "boolean" &&
    typeof transparent === "boolean" &&
    BACKGROUNDS.includes(background) &&
    /^#[0-9a-f]{6}$/.test(colour)
  );
}

/** Returns the colours in the middle and at the edge of the picture; null: the theme's. */
export function backgroundOf({ background, colour }: SceneLook): readonly [string, string] | null {
  if (background === "theme") return null;
  if (background === "colour") return [colour, colour];
  const parts = [1, 3, 5].map((at) => Math.round(EDGE * parseInt(colour.slice(at, at + 2), 16)));
  return [colour, `#${parts.map((part) => part.toString(16).padStart(2, "0")).join("")}`];
}

export class SceneSettings {
  readonly look = signal<SceneLook>(kept(PLACE, isLook, FIRST_LOOK));
  readonly isChanged = computed(() => JSON.stringify(this.look.value) !== JSON.stringify(FIRST_LOOK));

  set(part: Partial<SceneLook>): void {
    this.look.value = { ...this.look.value, ...part };
    keep(PLACE, this.look.value);
  }

  reset(): void {
    this.set(FIRST_LOOK);
  }
}
