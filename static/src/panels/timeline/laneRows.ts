/**
 * Places the timeline's lanes, in pixels from the top: the ruler, states, blends and events of each layer, then the
 * actions.
 */

export interface LayerRows {
  state: number;
  blend: number;
  events: number;
}

export interface LaneRows {
  layers: LayerRows[];
  /** Null if there are no actions yet. */
  actions: number | null;
  height: number;
}

export const RULER_HEIGHT = 16;
export const STATE_HEIGHT = 18;
export const BLEND_HEIGHT = 3;
export const EVENT_HEIGHT = 17;
export const ACTION_HEIGHT = 15;
/** Between two layers that are folded. */
const FOLDED_GAP = 6;
const LAYER_HEIGHT = STATE_HEIGHT + BLEND_HEIGHT + EVENT_HEIGHT + 3;

/** Returns the names of a cast's layers; before there is a cast, of the one lane that is drawn. */
export const layersOf = (cast: { layers: readonly string[] } | null | undefined): readonly string[] =>
  cast?.layers.length ? cast.layers : ["base"];

/**
 * Places the lanes of the layers that are folded or not: a folded one shows states alone, and if all are, no actions.
 * A layer is at least `least` high.
 */
export function laneRows(folded: readonly boolean[], hasActions: boolean, least = 0): LaneRows {
  let bottom = RULER_HEIGHT;
  const layers = folded.map((isFolded) => {
    const state = bottom;
    bottom += Math.max(least, isFolded ? STATE_HEIGHT + FOLDED_GAP : LAYER_HEIGHT);
    return { state, blend: state + STATE_HEIGHT, events: state + STATE_HEIGHT + BLEND_HEIGHT };
  });
  const isShown = hasActions && folded.includes(false);
  return { layers, actions: isShown ? bottom : null, height: bottom + (isShown ? ACTION_HEIGHT : 0) };
}
