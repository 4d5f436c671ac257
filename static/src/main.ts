/** The page: one session, one picture, the panels around it, and the loop that draws when there is something new. */

import "./style/base.css";
import "./style/layout.css";
import "./style/view.css";
import "./style/tally.css";
import "./style/parameters.css";
import "./style/graph.css";
import "./style/table.css";
import "./style/cells.css";
import "./style/editing.css";
import "./style/why.css";
import "./style/way.css";
import "./style/events.css";
import "./style/dialog.css";
import "./style/help.css";
import "./style/panels.css";
import "./style/timeline.css";
import "./style/drop.css";
import "./style/bring.css";
import "./style/mapping.css";
import { Editing } from "./editing";
import { type ViewerKey, Keyboard } from "./input";
import { Meter } from "./net/meter";
import { BringDialog } from "./panels/bring";
import { Chooser } from "./panels/chooser";
import { byId, el, onTheme, reducedMotion } from "./panels/dom";
import { dropZone } from "./panels/drop";
import { EventsPanel } from "./panels/events";
import { GraphPanel } from "./panels/graph";
import { HelpDialog } from "./panels/help";
import { StateBadge, modeBar, notices, toggleMode } from "./panels/overview";
import { ParametersPanel } from "./panels/parameters";
import { StatusPanel } from "./panels/status";
import { layerTabs } from "./panels/table/layertabs";
import { TableRoom } from "./panels/table/room";
import { tabs } from "./panels/tabs";
import { Tally } from "./panels/tally";
import { Timeline } from "./panels/timeline/timeline";
import { Transport } from "./panels/timeline/transport";
import { wayBar } from "./panels/waybar";
import { WhyPanel } from "./panels/why/whypanel";
import { Player } from "./player";
import { Session } from "./session";
import { exposeForTests } from "./testhook";
import { Travelling } from "./travelling";
import { Picture } from "./view/picture";
import { chooseQuality, rendererName } from "./view/quality";
import { Scene } from "./view/scene";

const PING_MS = 2000;
const READ_MS = 500;

function viewerKeys(session: Session, picture: Picture, transport: Transport, help: () => void): ViewerKey[] {
  const mode = (key: string, name: "skin" | "wire" | "bones" | "tetra"): ViewerKey => ({ keys: [key], words: `show ${name}`, act: () => toggleMode(picture, name) });
  return [
    { keys: ["p"], words: "pause, play", act: () => transport.toggle() },
    { keys: [","], words: "one tick back", act: () => transport.step(-1) },
    { keys: ["."], words: "one tick forward", act: () => transport.step(1) },
    { keys: ["l"], words: "live", act: () => session.live() },
    { keys: ["f"], words: "frame the character", act: () => picture.frame() },
    mode("1", "skin"),
    mode("2", "wire"),
    mode("3", "bones"),
    mode("4", "tetra"),
    { keys: ["g"], words: "pose stream, glb stream", act: () => session.stream(session.frames.value === "pose" ? "glb" : "pose") },
    { keys: ["?"], words: "this help", act: help },
  ];
}

/** The address names the stage, so that it can be reloaded and shared. */
function keepAddress(session: Session): void {
  session.hello.on((hello) => {
    if (!hello) return;
    const address = new URL(location.href);
    if (hello.stage === "main") address.searchParams.delete("stage");
    else address.searchParams.set("stage", hello.stage);
    history.replaceState(null, "", address);
  });
}

/** A click by pointer leaves no focus behind that would catch the character's keys. */
function freeFocus(): void {
  document.addEventListener("click", (click) => click.detail > 0 && click.target instanceof HTMLElement && click.target.closest("button")?.blur());
  document.addEventListener("change", (change) => change.target instanceof HTMLSelectElement && change.target.blur());
}

/** A character of one's own: dropped on the page, or chosen as a file. */
function bringOwn(chooser: Chooser): void {
  const dialog = new BringDialog((machine) => chooser.open(machine));
  dropZone((files) => dialog.take(files));
  byId("add").addEventListener("click", () => dialog.choose());
}

/** The why-panel; what it proposes is tried in the table and on the stage. */
function explainer(session: Session, table: TableRoom, travelling: Travelling): WhyPanel {
  const trials = {
    edit: (layer: number, state: string, event: string, text: string) => table.propose(layer, state, event, text),
    goTo: (state: string) => void travelling.go(state),
    look: (tick: number) => session.look(tick),
  };
  const why = new WhyPanel(byId("why"), session, trials, (layer, state, event) => table.go(layer, state, event));
  byId("verdict").addEventListener("click", () => {
    const { tick } = byId("verdict").dataset;
    if (tick) void why.open(Number(tick));
  });
  return why;
}

function start(name: string): void {
  const session = new Session();
  const scene = new Scene(byId<HTMLCanvasElement>("picture"), chooseQuality(name, location.search), reducedMotion);
  const picture = new Picture(scene, session);
  const player = new Player(session);
  const drawn = new Meter();
  const transport = new Transport(byId("transport"), session, player);
  const travelling = new Travelling(session);
  const table = new TableRoom(session, new Editing(session), travelling);
  const why = explainer(session, table, travelling);
  const timeline = new Timeline(byId("lanes"), byId("tools"), session, player, scene.quality === "low" ? 100 : 33, (tick) => void why.open(tick));
  const status = new StatusPanel(byId("status"), session, (now) => drawn.perSecond(now));
  const badge = new StateBadge(byId("badge"), session, picture);
  new ParametersPanel(byId("parameters"), session);
  const events = new EventsPanel(byId("events"), session);
  new GraphPanel(byId("graph"), session, (state) => void travelling.go(state));
  layerTabs(byId("layers"), session);
  wayBar(byId("way"), session, travelling);
  bringOwn(new Chooser(byId("chooser"), session));
  modeBar(byId("modes"), session, picture);
  new Tally(byId("tally"), session);
  notices(byId("notices"), session);
  tabs(byId("tabs"), byId("panels"));
  const keys = viewerKeys(session, picture, transport, () => help.toggle());
  const help = new HelpDialog(session, keys);
  byId("help").addEventListener("click", () => help.toggle());
  new Keyboard(session, keys, (event, down) => events.press(event, down));
  onTheme(() => picture.recolour());
  window.addEventListener("online", () => session.retry());
  setInterval(() => session.ping(), PING_MS);
  setInterval(() => status.update(performance.now()), READ_MS);
  keepAddress(session);
  freeFocus();
  exposeForTests(session, picture, drawn);
  let last = performance.now();
  const loop = (now: number): void => {
    const dt = Math.min(0.1, Math.max(0, (now - last) / 1000));
    last = now;
    player.advance(dt);
    const phase = session.phase();
    picture.update();
    if (scene.draw(dt)) drawn.add(now);
    badge.update(phase);
    transport.update();
    timeline.update(now);
    requestAnimationFrame(loop);
  };
  requestAnimationFrame(loop);
  session.watch(new URLSearchParams(location.search).get("stage") ?? "main");
}

const name = rendererName();
if (name) start(name);
else byId("loading").replaceChildren(el("p", {}, "This page draws with WebGL 2, which this browser does not offer or has turned off."));
