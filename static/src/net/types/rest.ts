/** Bodies of the REST interface under /api; machine.ts and explanation.ts have the larger ones. */

import type { ShippedCharacterView, UploadedCharacterView } from "./api.generated";

export type {
  AccessView as Access,
  BonesView as Bones,
  ActorView as ActorFacts,
  ClipView as Clip,
  ClampedView as ClampedJoint,
  DifferencesView as StageDifferences,
  EventLine,
  HistoryView as StateHistory,
  LogHeader,
  LogLine,
  MachineSummary,
  MappingView as Mapping,
  NewClip,
  NewClipView as CarriedClip,
  ProblemView as Problem,
  SceneView as SceneSummary,
  StageView as StageInfo,
  StateChangeView as StateChange,
  UploadView as UploadedCharacter,
} from "./api.generated";

export type CharacterSummary = ShippedCharacterView | UploadedCharacterView;
