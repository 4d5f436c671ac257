/** Lists what the palette finds: a name, what it is, and what choosing it does. */

import type { StageInfo } from "../../net/protocol";
import { keyCap } from "../../state/commands";
import type { App } from "../../view/app";
import type { Named } from "../../ui/matching";

export interface Hit extends Named {
  act: () => void;
}

const commandHits = ({ commands }: App): Hit[] =>
  commands.all.value.map(({ words, keys, act }) => ({ name: words, note: keys.map(keyCap).join(", "), act }));

/** Shows a state in the table, the graph and the inspector. */
function showState({ selection, inspection }: App, layer: number, name: string, state: string): void {
  selection.layer.value = layer;
  inspection.selected.value = { layer: name, state, event: null };
  inspection.drawer.value = "cell";
}

function stateHits(app: App): Hit[] {
  const layers = app.machine.info.value?.layers ?? [];
  return layers.flatMap(({ name: layer, states }, index) =>
    states.flatMap(({ name }) => {
      const show = { name, note: "state: show", act: () => showState(app, index, layer, name) };
      return index
        ? [show]
        : [show, { name, note: "state: travel there", act: () => void app.travel.go(name) }];
    }),
  );
}

const eventHits = ({ machine, session }: App): Hit[] =>
  (machine.info.value?.events ?? []).map((name) => ({
    name,
    note: "event: send",
    act: () => session.event("press", name),
  }));

/** A clip is shown in the first state that plays it, else where the shown state can take it. */
function clipHits(app: App): Hit[] {
  const { machine, library, selection } = app;
  const layers = machine.info.value?.layers ?? [];
  const players = layers.flatMap(({ name: layer, states }, index) =>
    states.map(({ name, clips }) => ({ clips, layer, index, name })),
  );
  return library.clipsOf(machine.info.value?.character ?? "").map(({ name }) => {
    const player = players.find(({ clips }) => clips.includes(name));
    const shown = players.find((state) => state.name === selection.shownState);
    const state = player ?? shown;
    return {
      name,
      note: player ? `clip: show ${player.name}, which plays it` : "clip: no state plays it; choose one",
      act: () => state && showState(app, state.index, state.layer, state.name),
    };
  });
}

function layerHits({ machine, selection }: App): Hit[] {
  const layers = machine.info.value?.layers ?? [];
  const hits = layers.map(({ name }, index) => ({
    name,
    note: "layer: show",
    act: () => (selection.layer.value = index),
  }));
  return hits.length > 1 ? hits : [];
}

const jointHits = ({ view: { watched } }: App): Hit[] =>
  watched.jointNames().flatMap((name) => [
    { name, note: "joint: show", act: () => (watched.joint.value = name) },
    { name, note: "joint: draw its path", act: () => (watched.traced.value = name) },
  ]);

function libraryHits({ library, stage, machine }: App): Hit[] {
  const machines = library.machines.value.filter(({ scene }) => !scene);
  const actors = stage.hello.value?.casts.flatMap((cast) => cast.actors) ?? [];
  return [
    ...machines.map(({ name, title }) => ({
      name: title,
      note: `machine ${name}: watch`,
      act: () => void library.openMachine(name),
    })),
    ...library.scenes.value.map(({ name, title }) => ({
      name: title,
      note: "scene: watch",
      act: () => void library.openScene(name),
    })),
    ...actors.map(({ id, name }) => ({ name, note: "actor: watch", act: () => void machine.choose(id) })),
  ];
}

const stageHits = ({ session, stage }: App, stages: readonly StageInfo[]): Hit[] =>
  stages
    .filter(({ id }) => id !== stage.id)
    .map(({ id, name, scene, machines }) => ({
      name: name || id,
      note: `stage: watch ${scene ?? machines.join(", ")}`,
      act: () => session.watch(id),
    }));

export function hitsOf(app: App, stages: readonly StageInfo[]): Hit[] {
  return [
    ...commandHits(app),
    ...stateHits(app),
    ...eventHits(app),
    ...layerHits(app),
    ...clipHits(app),
    ...jointHits(app),
    ...libraryHits(app),
    ...stageHits(app, stages),
  ];
}
