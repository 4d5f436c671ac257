/** The page's one state: plain parts, each made from the parts above it. Views and panels read it. */

import { Commands } from "./commands";
import { Editing } from "./editing";
import { Event } from "./event";
import { FootContacts } from "./footContacts";
import { Folds } from "./folds";
import { Frames } from "./frames";
import { Ghost } from "./ghost";
import { Inspection } from "./inspection";
import { KeyChanges } from "./keyChanges";
import { Library } from "./library";
import { Line } from "./line";
import { NameFilter } from "./nameFilter";
import type { Notice } from "./notice";
import { OwnStages } from "./ownStages";
import { ParameterValues } from "./parameterValues";
import { Past } from "./past";
import { People } from "./people";
import { Playback } from "./playback";
import { SceneSettings } from "./sceneSettings";
import { Selection } from "./selection";
import { Session } from "./session";
import { StageList } from "./stageList";
import { TimelineWindow } from "./timelineWindow";
import { Travel } from "./travel";
import { Viewpoint } from "./viewpoint";
import { WatchedMachine } from "./watchedMachine";
import { WatchedStage } from "./watchedStage";

export interface DrawnFrame {
  /** The browser's time, milliseconds. */
  now: number;
  /** Seconds by which keys, replays and cameras go on. */
  dt: number;
}

export type State = ReturnType<typeof makeState>;

export function makeState() {
  /** Emitted before each drawing; what moves by itself listens here. */
  const frame = new Event<DrawnFrame>();
  /** Sentences for the user. */
  const notices = new Event<Notice>();
  const line = new Line();
  const stage = new WatchedStage();
  const selection = new Selection(stage);
  const machine = new WatchedMachine(selection, notices);
  const contacts = new FootContacts(machine);
  const folds = new Folds(machine);
  const nameFilter = new NameFilter(machine);
  const past = new Past(stage, selection, machine);
  const playback = new Playback(stage, line.send);
  const frames = new Frames(line, stage, selection, past, playback);
  const session = new Session({ line, stage, selection, machine, past, playback, frames, notices });
  const stages = new OwnStages(session, stage, notices);
  const stageList = new StageList(stage);
  const ghost = new Ghost(stage, notices);
  const viewpoint = new Viewpoint();
  const people = new People(line, stage, selection, notices);
  const library = new Library(session, stages);
  const travel = new Travel(session, selection, playback);
  const editing = new Editing(machine, notices);
  const parameters = new ParameterValues(line, stage, selection, machine);
  const keyChanges = new KeyChanges(parameters, () => selection.layerStates.value);
  const inspection = new Inspection();
  editing.kept.on((operations) => inspection.follow(operations));
  const commands = new Commands();
  const timeline = new TimelineWindow(stage, playback);
  const scene = new SceneSettings();
  frame.on(({ dt }) => keyChanges.advance(dt));
  frame.on(({ dt }) => playback.advance(dt));
  return {
    frame,
    notices,
    line,
    stage,
    selection,
    machine,
    contacts,
    folds,
    nameFilter,
    past,
    playback,
    frames,
    session,
    stages,
    stageList,
    ghost,
    people,
    viewpoint,
    library,
    travel,
    editing,
    parameters,
    keyChanges,
    inspection,
    commands,
    scene,
    timeline,
  };
}
