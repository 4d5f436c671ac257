/** Puts the page together: one session, one stage view, the panels, and the loop that draws. */

import "./style/tokens.css";
import "./style/base.css";
import "./style/components.css";
import "./style/layout.css";
import { Editing } from "./state/editing";
import { accessWord } from "./panels/access/access";
import { Keyboard } from "./panels/events/keyboard";
import type { Shortcut } from "./ui/shortcut";
import { Meter } from "./net/meter";
import { ImportDialog } from "./panels/importDialog/importDialog";
import { Picker } from "./panels/picker/picker";
import { byId, el, onTheme, reducedMotion } from "./ui/dom";
import { dropZone } from "./panels/importDialog/dropZone";
import { JointPanel } from "./panels/joint/joint";
import { PoseTrial } from "./panels/joint/poseTrial";
import { clampedPanel } from "./panels/clamped/clamped";
import { EventsPanel } from "./panels/events/events";
import { FeetStrip } from "./panels/feet/feet";
import { GraphPanel } from "./panels/graph/graph";
import { HelpDialog } from "./panels/help/help";
import { StateBadge, modeBar, notices, toggleMode, wireOrSkin } from "./panels/viewControls/viewControls";
import { DeduceDialog } from "./panels/deduce/deduceDialog";
import { DownloadDialog } from "./panels/download/downloadDialog";
import { ExpressionsPanel } from "./panels/expressions/expressions";
import { ParametersPanel } from "./panels/parameters/parameters";
import { TargetsPanel } from "./panels/targets/targets";
import { StatusPanel } from "./panels/status/status";
import { layerTabs } from "./panels/table/layerTabs";
import { TableController } from "./panels/table/tableController";
import { tabs } from "./ui/tabs";
import { ActionCounter } from "./panels/actionCounter/actionCounter";
import { Timeline } from "./panels/timeline/timeline";
import { Transport } from "./panels/timeline/transport";
import { routeBar } from "./panels/routeBar/routeBar";
import { WhyPanel } from "./panels/why/why";
import { KeyChanges } from "./state/keyChanges";
import { OwnStages } from "./state/ownStages";
import { ParameterValues } from "./state/parameterValues";
import { Player } from "./state/player";
import { Session } from "./state/session";
import { exposeForTests } from "./testHook";
import { Travel } from "./state/travel";
import { type Modes, StageView } from "./view/stageView";
import { chooseQuality, rendererName } from "./view/quality";
import { Scene } from "./view/scene";
import { teachSkinning } from "./view/skinShader";
import "./style/panels.css";

const PING_MS = 2000;
const READ_MS = 500;

function viewerKeys(
  session: Session,
  stageView: StageView,
  transport: Transport,
  help: () => void,
): Shortcut[] {
  const mode = (key: string, name: keyof Modes, ...more: string[]): Shortcut => ({
    keys: [key, ...more],
    words: `show ${name}`,
    act: () => toggleMode(stageView, name),
  });
  return [
    { keys: ["p"], words: "pause, play", act: () => transport.toggle() },
    { keys: [","], words: "one tick back", act: () => transport.step(-1) },
    { keys: ["."], words: "one tick forward", act: () => transport.step(1) },
    { keys: ["l"], words: "live", act: () => session.live() },
    { keys: ["f"], words: "frame the character", act: () => stageView.watched.frame() },
    mode("1", "skin"),
    mode("2", "wire"),
    mode("3", "bones", "b"),
    mode("4", "tetra"),
    mode("5", "limits"),
    { keys: ["t"], words: "wire, smooth skin", act: () => wireOrSkin(stageView) },
    {
      keys: ["r"],
      words: "turntable",
      act: () => stageView.watched.turning.set(!stageView.watched.turning.value),
    },
    {
      keys: ["g"],
      words: "pose stream, glb stream",
      act: () => session.stream(session.frames.value === "pose" ? "glb" : "pose"),
    },
    { keys: ["?"], words: "this help", act: help },
  ];
}

/** Keeps the stage's name in the address, so that you can reload and share it, and what it began with. */
function keepAddress(session: Session, stages: OwnStages): void {
  session.hello.on((hello) => {
    if (!hello) return;
    const address = new URL(location.href);
    if (hello.stage === "main") address.searchParams.delete("stage");
    else address.searchParams.set("stage", hello.stage);
    history.replaceState(stages.openingOf(hello.stage), "", address);
  });
}

/** Takes the focus off a clicked button or select, or a dragged slider: it would catch the character's keys. */
function freeFocus(): void {
  document.addEventListener(
    "click",
    (click) =>
      click.detail > 0 && click.target instanceof HTMLElement && click.target.closest("button")?.blur(),
  );
  document.addEventListener(
    "change",
    (change) => change.target instanceof HTMLSelectElement && change.target.blur(),
  );
  document.addEventListener("pointerup", ({ target }) => {
    if (target instanceof HTMLInputElement && target.type === "range") target.blur();
  });
}

/** Imports your own character: dropped on the page, or chosen as a file. */
function importOwn(picker: Picker, session: Session, travel: Travel): void {
  const made = async (machine: string, state = ""): Promise<void> => {
    await picker.open(machine);
    if (state) playOnce(session, machine, () => void travel.go(state));
  };
  const dialog = new ImportDialog(made, () => session.machine.value?.character ?? null);
  dropZone((files) => void dialog.take(files));
  byId("add").addEventListener("click", () => dialog.choose());
  const download = new DownloadDialog(() => session.machine.value?.character ?? null);
  byId("download").addEventListener("click", () => void download.open());
}

/** Calls `then` as soon as the page knows the machine that it has begun to watch. */
function playOnce(session: Session, machine: string, then: () => void): void {
  let done = false;
  const forget = session.machine.on((known) => {
    if (done || known?.name !== machine || session.cast?.machine !== machine) return;
    done = true;
    queueMicrotask(() => forget());
    then();
  });
}

/** Makes the why panel; you can try its remedies in the table and on the stage. */
function explainer(session: Session, table: TableController, travel: Travel): WhyPanel {
  const actions = {
    edit: (layer: number, state: string, event: string, text: string) =>
      table.propose(layer, state, event, text),
    goTo: (state: string) => void travel.go(state),
    look: (tick: number) => session.look(tick),
  };
  const why = new WhyPanel(byId("why"), session, actions, (layer, state, event) =>
    table.go(layer, state, event),
  );
  byId("verdict").addEventListener("click", () => {
    const { tick } = byId("verdict").dataset;
    if (tick) void why.open(Number(tick));
  });
  return why;
}

function start(name: string): void {
  teachSkinning();
  const session = new Session();
  const stages = new OwnStages(session);
  const scene = new Scene(
    byId<HTMLCanvasElement>("stage-view"),
    chooseQuality(name, location.search),
    reducedMotion,
  );
  const stageView = new StageView(scene, session);
  const player = new Player(session);
  const drawn = new Meter();
  const transport = new Transport(byId("transport"), session, player);
  const travel = new Travel(session);
  const editing = new Editing(session);
  const table = new TableController(session, editing, travel);
  const why = explainer(session, table, travel);
  const timeline = new Timeline(
    byId("lanes"),
    byId("tools"),
    session,
    player,
    scene.quality === "low" ? 100 : 33,
    (tick) => void why.open(tick),
  );
  const status = new StatusPanel(byId("status"), session, (now) => drawn.perSecond(now));
  accessWord(byId("access"), session);
  const badge = new StateBadge(byId("badge"), session, stageView);
  const feet = new FeetStrip(byId("badge"), session);
  const values = new ParameterValues(session);
  const changes = new KeyChanges(values, () => session.layerStates.value);
  new ParametersPanel(byId("parameters"), session, values);
  new ExpressionsPanel(byId("expressions"), session, editing);
  clampedPanel(byId("clamped"), session);
  const joint = new JointPanel(byId("joint"), session, stageView, values);
  const trial = new PoseTrial(byId("trial"), session, stageView);
  const targets = new TargetsPanel(byId("targets"), session, stageView, values);
  const events = new EventsPanel(byId("events"), session);
  new GraphPanel(byId("graph"), session, (state) => void travel.go(state));
  layerTabs(byId("layers"), session);
  routeBar(byId("route"), session, travel);
  importOwn(new Picker(byId("picker"), session, stages), session, travel);
  modeBar(byId("modes"), session, stageView);
  scene.leaveRoomFor(byId("modes"));
  new ActionCounter(byId("action-counter"), session);
  notices(byId("notices"), session);
  tabs(byId("tabs"), byId("panels"));
  const keys = viewerKeys(session, stageView, transport, () => help.toggle());
  const help = new HelpDialog(session, keys);
  byId("help").addEventListener("click", () => help.toggle());
  const rules = new DeduceDialog();
  byId("deduce").addEventListener("click", () => rules.open());
  new Keyboard(session, keys, changes, (event, down) => events.press(event, down));
  onTheme(() => stageView.recolour());
  for (const back of ["online", "focus"]) window.addEventListener(back, () => session.retry());
  setInterval(() => session.ping(), PING_MS);
  setInterval(() => status.update(performance.now()), READ_MS);
  keepAddress(session, stages);
  freeFocus();
  exposeForTests(session, stageView, drawn, () => ({
    ...targets.places(),
    ...joint.places(),
    ...trial.places(),
  }));
  let last = performance.now();
  const loop = (now: number): void => {
    const passed = Math.max(0, (now - last) / 1000);
    const dt = Math.min(0.1, passed);
    last = now;
    changes.advance(Math.min(0.5, passed));
    player.advance(dt);
    const phase = session.phase();
    stageView.update();
    joint.update();
    targets.update();
    trial.update(Object.keys(joint.places()).length > 0);
    if (scene.draw(dt)) drawn.add(now);
    badge.update(phase);
    feet.update(phase);
    transport.update();
    timeline.update(now);
    requestAnimationFrame(loop);
  };
  requestAnimationFrame(loop);
  void stages.begin(new URLSearchParams(location.search).get("stage"));
}

const name = rendererName();
if (name) start(name);
else
  byId("loading").replaceChildren(
    el("p", {}, "This page needs WebGL 2. Your browser does not offer it, or you have turned it off."),
  );
