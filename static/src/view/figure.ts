/** One actor as it stands in the scene: its skinned model, its bones, and the spot of shade below it. */

import type { CastHello } from "../net/protocol";
import { ActorView } from "./actor";
import { contactShadow } from "./ground";
import type { Model } from "./model";
import { BoneOverlay } from "./overlays";
import type { Scene } from "./scene";
import { type SkinLook, showSkin } from "./skinmode";

export interface FigureColours {
  ink: string;
  accent: string;
  bone: string;
}

export class Figure {
  readonly view: ActorView;
  private readonly bones: BoneOverlay;
  private readonly spot = contactShadow();

  constructor(
    id: number,
    cast: CastHello,
    model: Model,
    private readonly scene: Scene,
  ) {
    this.view = new ActorView(id, cast, model, scene.quality === "high");
    this.bones = new BoneOverlay(this.view, scene.renderer.getPixelRatio());
    // Nothing is shown before the first frame: a character in its bind pose is none.
    this.hide();
    scene.world.add(this.view.root, this.bones.object, this.spot);
  }

  /** The camera is set anew for another actor or another model, not for a fork or a reconnection. */
  get key(): string {
    return `${this.view.id} ${this.view.model.url}`;
  }

  /** Where it looks, radians about +Y; 0 is +Z. */
  get heading(): number {
    const { x, y, z, w } = this.view.root.quaternion;
    return Math.atan2(2 * (w * y + x * z), 1 - 2 * (x * x + y * y));
  }

  /** The frame was applied: the rest follows. */
  settle(): void {
    const { root } = this.view;
    root.visible = true;
    root.updateMatrixWorld(true);
    this.bones.update();
    this.spot.visible = this.scene.quality === "low";
    this.spot.position.set(root.position.x, 0.002, root.position.z);
  }

  hide(): void {
    this.view.root.visible = false;
    this.spot.visible = false;
  }

  show(look: SkinLook, lines: boolean, solids: boolean): void {
    showSkin(this.view.meshes, look);
    this.bones.show(lines, solids);
    this.bones.update();
  }

  colour({ ink, accent, bone }: FigureColours): void {
    this.bones.colour(ink, accent, bone);
  }

  /** Sets the size of the spot, metres. */
  shade(radius_m: number): void {
    this.spot.scale.setScalar(radius_m);
  }

  dispose(): void {
    this.bones.dispose();
    this.scene.world.remove(this.view.root, this.spot);
  }
}
