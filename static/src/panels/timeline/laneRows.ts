/**
 * Places the timeline's lanes, in pixels from the top: states, blends and events of each layer, then the
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

export const GRIP_HEIGHT = 10;
export const STATE_HEIGHT = 18;
export const BLEND_HEIGHT = 3;
export const EVENT_HEIGHT = 17;
export const ACTION_HEIGHT = 15;
const LAYER_HEIGHT = STATE_HEIGHT + BLEND_HEIGHT + EVENT_HEIGHT + 3;

export function laneRows(layers: number, hasActions: boolean): LaneRows {
  const rows = Array.from({ length: Math.max(1, layers) }, (_, layer) => {
    const state = GRIP_HEIGHT + layer * LAYER_HEIGHT;
    return { state, blend: state + STATE_HEIGHT, events: state + STATE_HEIGHT + BLEND_HEIGHT };
  });
  const bottom = GRIP_HEIGHT + rows.length * LAYER_HEIGHT;
  return {
    layers: rows,
    actions: hasActions ? bottom : null,
    height: bottom + (hasActions ? ACTION_HEIGHT : 0),
  };
}
