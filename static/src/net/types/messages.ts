/** Messages of the socket (`statwalk.v1`), in both directions, under the page's names. */

import type { CastView, ChooseFrames, PostEvent } from "./api.generated";

export type {
  AcceptedMessage as Accepted,
  ActionMessage as Action,
  ActorName,
  CastView as CastHello,
  ErrorMessage as Refused,
  Forked,
  Hello,
  Pong,
  ServerMessage,
  StatusMessage as Status,
  VerdictMessage as Verdict,
  ViewerMessage as ClientMessage,
} from "./api.generated";

export type Skinning = CastView["skinning"];
export type FrameKind = ChooseFrames["frames"];
export type EventKind = NonNullable<PostEvent["kind"]>;
