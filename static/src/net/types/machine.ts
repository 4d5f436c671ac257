/** A machine as the server describes it: layers, tables, findings, versions, under the page's names. */

export type {
  AlternativeView as Alternative,
  CellView as Cell,
  EdgeView as Edge,
  EditedMachine as Edited,
  FindingView as Finding,
  GroundView as GroundPiece,
  KeyView as KeyBinding,
  LayerView as LayerInfo,
  MarkerView as Marker,
  DeducedBoneView as DeducedBone,
  LimitView as JointLimit,
  MachineView as MachineInfo,
  SolverView as Solver,
  SolveView as Solved,
  ParameterView as Parameter,
  StateView as StateInfo,
  VersionDifferencesView as VersionDifferences,
  VersionView as MachineVersion,
} from "./api.generated";

import type { MachineView, NewOperations } from "./api.generated";

/** One change of a machine; several together make one version. */
export type Operation = NewOperations["operations"][number];

/** What raises an event: a condition, or a touch of two colliders. */
export type Sense = MachineView["senses"][string];
