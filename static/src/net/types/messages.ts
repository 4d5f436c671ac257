/** Messages of the socket (`statwalk.v1`), in both directions, under the page's names. */

import type { CameraMessage, CastView, ChooseFrames, PostEvent } from "./api.generated";

export type {
  AcceptedMessage as Accepted,
  ActionMessage as Action,
  ActorName,
  CastView as CastHello,
  ClockChangeView as ClockChange,
  ErrorMessage as Refused,
  Forked,
  Hello,
  Pong,
  ServerMessage,
  StatusMessage as Status,
  VerdictMessage as Verdict,
  ViewerMessage as ClientMessage,
  ViewerView as Viewer,
} from "./api.generated";

/** Where a viewer stands, and what it looks at: metres from the root of `actor`; null: on the stage. */
export type CameraAt = Pick<CameraMessage, "position" | "target" | "actor">;
export type Skinning = CastView["skinning"];
export type FrameKind = ChooseFrames["frames"];
export type EventKind = NonNullable<PostEvent["kind"]>;
