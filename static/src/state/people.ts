/** Who watches the stage: their names, what they look at, whose camera this page follows, who paused. */

import { signal } from "@preact/signals-core";
import type { CameraAt, Hello, ServerMessage, Status, Viewer } from "../net/protocol";
import { changeWords } from "./changeWords";
import { Event } from "./event";
import { keepName, keptName } from "./keptName";
import type { Line } from "./line";
import type { Notice } from "./notice";
import type { Selection } from "./selection";
import type { WatchedStage } from "./watchedStage";

/** Milliseconds between two cameras of this page: the server takes ten a second. */
const CAMERA_MS = 120;

export class People {
  readonly all = signal<readonly Viewer[]>([]);
  /** What this page's user is called; empty: the user has not said. */
  readonly name = signal(keptName());
  /** The viewer whose camera this page follows, or null. */
  readonly following = signal<number | null>(null);
  /** Emitted with each camera of the followed viewer. */
  readonly cameras = new Event<CameraAt>();
  private toldChange = "";
  private sentCamera = "";
  private sentAt = 0;

  constructor(
    private readonly line: Line,
    private readonly stage: WatchedStage,
    selection: Selection,
    private readonly notices: Event<Notice>,
  ) {
    line.messages.on((message) => this.hear(message));
    stage.hello.subscribe((hello) => hello && this.greet(selection.actor.value));
    selection.actor.subscribe((actor) => line.send({ type: "watch", actor }));
  }

  /** The number of this page among the stage's viewers. */
  get self(): number | null {
    return this.stage.hello.value?.viewer ?? null;
  }

  rename(name: string): void {
    this.name.value = name;
    keepName(name);
    this.line.send({ type: "name", name });
  }

  /** Follows the camera of a viewer; null: of none. */
  follow(viewer: number | null): void {
    if (viewer === this.following.value) return;
    this.following.value = viewer;
    this.line.send({ type: "follow", viewer });
  }

  /** Tells where this page looks from, if that is new and another page may follow. */
  look(camera: CameraAt, now: number): void {
    const isAlone = this.all.value.length < 2;
    if (isAlone || this.following.value !== null || now - this.sentAt < CAMERA_MS) return;
    const text = JSON.stringify(camera);
    if (text === this.sentCamera || !this.line.send({ type: "camera", ...camera })) return;
    this.sentCamera = text;
    this.sentAt = now;
  }

  private greet(actor: number | null): void {
    this.following.value = null;
    this.sentCamera = "";
    if (this.name.value) this.line.send({ type: "name", name: this.name.value });
    if (actor !== null) this.line.send({ type: "watch", actor });
  }

  private hear(message: ServerMessage): void {
    if (message.type === "hello") this.toldChange = JSON.stringify(message.changed);
    else if (message.type === "status") this.tellChange(message);
    else if (message.type === "viewers") this.take(message.viewers);
    else if (message.type === "camera" && message.viewer === this.following.value) this.cameras.emit(message);
  }

  private take(viewers: readonly Viewer[]): void {
    this.all.value = viewers;
    if (this.following.value === null || viewers.some(({ id }) => id === this.following.value)) return;
    this.following.value = null;
    this.notices.emit("The viewer whose camera you followed has left.");
  }

  /** Says what another viewer, or a program, has done to the stage's time. */
  private tellChange({ changed }: Pick<Status | Hello, "changed">): void {
    const text = JSON.stringify(changed);
    if (text === this.toldChange) return;
    this.toldChange = text;
    if (changed && changed.viewer !== this.self) this.notices.emit(changeWords(changed));
  }
}
