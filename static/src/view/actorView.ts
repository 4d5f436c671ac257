/** Shows one actor: its skinned model, its bones, and the shadow below it. */

import type { CastHello } from "../net/protocol";
import { PosedModel } from "./posedModel";
import { contactShadow } from "./ground";
import type { Model } from "./model";
import { LimitOverlay } from "./limitOverlay";
import { BoneOverlay } from "./overlays";
import type { Scene } from "./scene";
import { type SkinLook, showSkin } from "./skinMode";

export interface ActorColours {
  ink: string;
  accent: string;
  bone: string;
}

export class ActorView {
  readonly view: PosedModel;
  readonly bones: BoneOverlay;
  readonly limits: LimitOverlay;
  private readonly spot = contactShadow();

  constructor(
    id: number,
    cast: CastHello,
    model: Model,
    private readonly scene: Scene,
  ) {
    this.view = new PosedModel(id, cast, model, scene.quality === "high");
    this.bones = new BoneOverlay(this.view, scene.renderer.getPixelRatio());
    this.limits = new LimitOverlay(this.view, scene.renderer.getPixelRatio());
    // Hidden until the first frame: the bind pose is not shown.
    this.view.root.visible = this.spot.visible = false;
    scene.world.add(this.view.root, this.bones.object, this.limits.object, this.spot);
  }

  /**
   * Changes with the actor and the model, not with a fork or a reconnection; the camera frames each key once.
   */
  get key(): string {
    return `${this.view.id} ${this.view.model.url}`;
  }

  /** Heading, radians about +Y; 0 is +Z. */
  get heading(): number {
    const { x, y, z, w } = this.view.root.quaternion;
    return Math.atan2(2 * (w * y + x * z), 1 - 2 * (x * x + y * y));
  }

  /** Shows the model, its bones and its shadow after a frame was applied. */
  settle(): void {
    this.view.root.visible = true;
    this.view.root.updateMatrixWorld(true);
    this.attach();
  }

  /** Shows bones and shadow where the server's skin is; `matrices` (1+J, 16) of root and joints. */
  place(matrices: Float32Array | undefined): void {
    this.view.root.visible = false;
    // The last frame before another hello has other actors.
    if (matrices?.length !== 16 * (1 + this.view.cast.joints)) return;
    this.view.place(matrices);
    this.attach();
  }

  private attach(): void {
    const { root } = this.view;
    this.bones.update();
    this.limits.update();
    this.spot.visible = this.scene.quality === "low";
    this.spot.position.copy(root.position).y += 0.002;
  }

  show(look: SkinLook, lines: boolean, solids: boolean): void {
    showSkin(this.view.meshes, look);
    this.bones.show(lines, solids);
    this.bones.update();
  }

  colour({ ink, accent, bone }: ActorColours): void {
    this.bones.colour(ink, accent, bone);
    this.limits.colour(ink, accent);
  }

  /** Sets the radius of the shadow, metres. */
  shade(radius_m: number): void {
    this.spot.scale.setScalar(radius_m);
  }

  dispose(): void {
    this.bones.dispose();
    this.limits.dispose();
    this.scene.world.remove(this.view.root, this.spot);
  }
}
