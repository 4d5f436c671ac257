/** Puts the page together: one state, one stage view, the panels, and the loop that draws. */

import "./style/tokens.css";
import "./style/base.css";
import "./style/components.css";
import "./style/layout.css";
import { accessPanel } from "./panels/access/access";
import { actionCounterPanel } from "./panels/actionCounter/actionCounter";
import { badgePanel } from "./panels/badge/badge";
import { barMenuPanel } from "./panels/barMenu/barMenu";
import { cellInspectorPanel } from "./panels/cellInspector/cellInspector";
import { clampedPanel } from "./panels/clamped/clamped";
import { deducePanel } from "./panels/deduce/deduceDialog";
import { downloadPanel } from "./panels/download/downloadDialog";
import { drawerPanel } from "./panels/drawer/drawer";
import { eventsPanel } from "./panels/events/events";
import { expressionsPanel } from "./panels/expressions/expressions";
import { feetPanel } from "./panels/feet/feet";
import { graphPanel } from "./panels/graph/graph";
import { helpPanel } from "./panels/help/help";
import { importPanel } from "./panels/importDialog/importPanel";
import { jointPanel } from "./panels/joint/joint";
import { layerTabsPanel } from "./panels/layerTabs/layerTabs";
import { loadingPanel } from "./panels/loading/loading";
import { machineFormPanel } from "./panels/machineForm/machineForm";
import { machineMenuPanel } from "./panels/machineMenu/machineMenu";
import { noticesPanel } from "./panels/notices/notices";
import { palettePanel } from "./panels/palette/palette";
import { parametersPanel } from "./panels/parameters/parameters";
import { peoplePanel } from "./panels/people/people";
import { pickerPanel } from "./panels/picker/picker";
import { routeBarPanel } from "./panels/routeBar/routeBar";
import { scenePanel } from "./panels/scene/scene";
import { stageNamePanel } from "./panels/stageName/stageName";
import { stagesPanel } from "./panels/stages/stages";
import { statusPanel } from "./panels/status/status";
import { tablePanel } from "./panels/table/tablePanel";
import { targetsPanel } from "./panels/targets/targets";
import { timelinePanel } from "./panels/timeline/timeline";
import { versionsPanel } from "./panels/versions/versions";
import { viewControlsPanel } from "./panels/viewControls/viewControls";
import { whyPanel } from "./panels/why/why";
import { yamlPanel } from "./panels/yaml/yaml";
import { keepAddress } from "./state/keepAddress";
import { exposeForTests } from "./testHook";
import { byId, canvasById, el } from "./ui/dom";
import { freeFocus } from "./ui/focus";
import { tabs } from "./ui/tabs";
import { type App, makeApp, type Panel } from "./view/app";
import { leastStep_s, rendererName } from "./view/quality";
import "./style/panels.css";
import "./style/kiosk.css";

/** The panels, each with the id of its element in `index.html`. */
const PANELS: readonly (readonly [string, Panel])[] = [
  ["picker", pickerPanel],
  ["machine-menu", machineMenuPanel],
  ["add", importPanel],
  ["download", downloadPanel],
  ["stage-name", stageNamePanel],
  ["access", accessPanel],
  ["status", statusPanel],
  ["deduce", deducePanel],
  ["badge", badgePanel],
  ["badge", feetPanel],
  ["loading", loadingPanel],
  ["notices", noticesPanel],
  ["action-counter", actionCounterPanel],
  ["route", routeBarPanel],
  ["layers", layerTabsPanel],
  ["graph", graphPanel],
  ["table-panel", tablePanel],
  ["expressions", expressionsPanel],
  ["why", whyPanel],
  ["parameters", parametersPanel],
  ["clamped", clampedPanel],
  ["joint", jointPanel],
  ["targets", targetsPanel],
  ["events", eventsPanel],
  ["timeline", timelinePanel],
  ["modes", viewControlsPanel],
  ["scene", scenePanel],
  ["cell", cellInspectorPanel],
  ["machine-form", machineFormPanel],
  ["versions", versionsPanel],
  ["text", yamlPanel],
  ["stages", stagesPanel],
  ["people", peoplePanel],
  ["drawer", drawerPanel],
  ["palette", palettePanel],
  ["help", helpPanel],
  ["bar-menu", barMenuPanel],
];

/** The panels of a page in a hall: the character alone, and nothing that changes it. */
const KIOSK: readonly string[] = ["loading"];

const PING_MS = 2000;
/** Limits the step of keys, replays and cameras after the page was hidden or held up. */
const LONGEST_STEP_S = 0.5;

/**
 * Emits `frame` and draws, as often as the quality allows: numbers and marks that change with each tick take a software
 * renderer as long as the character.
 */
function drawForever({ frame, view }: App): void {
  const least_s = leastStep_s(view.scene.quality, location.search);
  let last = performance.now();
  const draw = (now: number): void => {
    requestAnimationFrame(draw);
    const passed_s = Math.max(0, (now - last) / 1000);
    if (passed_s < least_s) return;
    last = now;
    const dt = Math.min(LONGEST_STEP_S, passed_s);
    frame.emit({ now, dt });
    view.draw(now, dt);
  };
  requestAnimationFrame(draw);
}

function start(renderer: string): void {
  const app = makeApp(canvasById("stage-view"), renderer);
  const isKiosk = new URLSearchParams(location.search).has("kiosk");
  document.body.classList.toggle("kiosk", isKiosk);
  for (const [id, panel] of PANELS) if (!isKiosk || KIOSK.includes(id)) panel(byId(id), app);
  tabs(byId("tabs"), byId("panels"));
  freeFocus();
  exposeForTests(app);
  for (const back of ["online", "focus"]) window.addEventListener(back, () => app.line.retry());
  setInterval(() => app.session.ping(), PING_MS);
  drawForever(app);
  keepAddress(app);
}

const renderer = rendererName();
if (renderer) start(renderer);
else
  byId("loading").replaceChildren(
    el("p", {}, "This page needs WebGL 2. Your browser does not offer it, or you have turned it off."),
  );
