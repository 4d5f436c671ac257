/** Shows the actors of a cast: their skins, their bones, and the shadows below them. */

import * as THREE from "three";
import type { CastHello, Skinning } from "../net/protocol";
import type { CastFrame } from "../net/wire";
import { token } from "../ui/dom";
import { Crowd } from "./crowd";
import { contactShadows } from "./ground";
import type { Solid } from "./looks";
import type { Model } from "./model";
import { BoneOverlay } from "./overlays";
import type { Scene } from "./scene";
import { type SkinLook, showSkin } from "./skinMode";

/** Height of the shadows above the actors' places, metres. */
const ABOVE_M = 0.002;

export interface ActorColours {
  ink: string;
  accent: string;
  bone: string;
}

export const themeColours = (): ActorColours => ({
  ink: token("--ink"),
  accent: token("--accent"),
  bone: token("--bone"),
});

export class CastView {
  readonly crowd: Crowd;
  readonly bones: BoneOverlay;
  /** In place of a model that cannot be loaded. */
  private readonly signs: THREE.Object3D[];
  private readonly spots: THREE.InstancedMesh;
  private radius = 1;

  constructor(
    readonly cast: CastHello,
    model: Model,
    private readonly scene: Scene,
  ) {
    this.crowd = new Crowd(cast, model, scene.quality === "high");
    this.bones = new BoneOverlay(this.crowd, scene.renderer.getPixelRatio());
    this.signs = model.wrong ? cast.actors.map(() => model.scene.clone()) : [];
    for (const sign of this.signs) this.crowd.root.add(sign);
    this.spots = contactShadows(cast.actors.length);
    this.spots.visible = false;
    scene.world.add(this.crowd.root, this.bones.object, this.spots);
  }

  /** Shows a frame of the pose stream. */
  take(frame: CastFrame): void {
    this.crowd.take(frame);
    this.attach();
  }

  /**
   * Shows bones and shadows where the server's skins are; `matrices` belong to the roots and joints of
   * the actors.
   */
  place(matrices: readonly Float32Array[]): void {
    this.cast.actors.forEach((_, row) => this.crowd.place(row, matrices[row]));
    this.attach();
  }

  private attach(): void {
    this.bones.update();
    this.signs.forEach((sign, row) => sign.position.setFromMatrixPosition(this.root(row)));
    if (this.scene.quality === "high") return;
    const [size, spot] = [new THREE.Vector3().setScalar(this.radius), new THREE.Matrix4()];
    for (let row = 0; row < this.crowd.pose.actors; row++) {
      const { elements } = spot.identity().scale(size).copyPosition(this.root(row));
      elements[13] += ABOVE_M;
      this.spots.setMatrixAt(row, spot);
    }
    this.spots.instanceMatrix.needsUpdate = true;
  }

  /** Prepares what `camera` sees; called before each drawing. */
  arrange(camera: THREE.PerspectiveCamera): void {
    this.crowd.arrange(camera);
    this.spots.visible = this.scene.hasSpots;
  }

  private root(row: number): THREE.Matrix4 {
    return new THREE.Matrix4().fromArray(this.crowd.pose.world(row, -1));
  }

  show(look: SkinLook, lines: boolean, solids: Solid | null): void {
    showSkin(this.crowd.bodies, look);
    // A model without meshes would be invisible.
    const bare = !this.crowd.bodies.length && !this.crowd.model.wrong;
    this.bones.show(lines || (bare && solids === null), solids);
    this.bones.update();
  }

  /** Skins in a way; null: the character's own. */
  skin(way: Skinning | null): void {
    this.crowd.skin(way ?? this.cast.skinning);
  }

  colour({ ink, accent, bone }: ActorColours): void {
    this.bones.colour(ink, accent, bone);
  }

  /** Sets the radius of the shadows, metres. */
  shade(radius_m: number): void {
    this.radius = radius_m;
    this.attach();
  }

  dispose(): void {
    this.bones.dispose();
    this.crowd.dispose();
    this.spots.removeFromParent();
    this.spots.geometry.dispose();
    (this.spots.material as THREE.Material).dispose();
    this.spots.dispose();
  }
}
