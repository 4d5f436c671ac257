/** A pad with the clips of a blend: drag a clip to another place, drag the cross to see the blend there. */

import "./blendPad.css";
import type { Signal } from "@preact/signals-core";
import { nothing, svg, type TemplateResult } from "lit-html";
import type { StateInfo } from "../../net/protocol";
import type { App } from "../../view/app";
import { along, type Axis, axesOf, clamped, type Place, putClip, stepped, valueAt } from "./blendSpace";
import { weightsAt, wholePercent } from "./blendWeights";

/** Units of the drawing; a blend over one value is a line. */
const [WIDTH, HEIGHT, LINE_HEIGHT, EDGE] = [300, 200, 72, 24];
const CROSS = "M-9 0H9M0-9V9";

/** A clip, or (null) the cross, that is dragged, and where it is. */
export interface Drag {
  clip: string | null;
  place: Place;
}

export class BlendPad {
  private readonly axes: Axis[];
  private readonly height: number;

  constructor(
    private readonly app: App,
    private readonly drag: Signal<Drag | null>,
    private readonly layer: string,
    private readonly state: StateInfo,
  ) {
    this.axes = axesOf(state, app.machine.info.value?.parameters ?? []);
    this.height = this.axes.length > 1 ? HEIGHT : LINE_HEIGHT;
  }

  template(): TemplateResult {
    const { axes, height, state } = this;
    const [across, up] = axes;
    const isDrivable = axes.every(({ parameter }) => parameter !== null);
    const shares = isDrivable ? weightsAt(state.points, clamped(axes, this.values())) : null;
    const percent = shares && wholePercent(shares);
    return svg`<svg class="blend-pad" viewBox="0 0 ${WIDTH} ${height}" role="group"
      aria-label=${`blend over ${axes.map(({ name }) => name).join(" and ")}`}>
      <rect class="room" x=${EDGE} width=${WIDTH - 2 * EDGE} y=${up ? EDGE : height / 2 - 1}
        height=${up ? height - 2 * EDGE : 2} />
      ${isDrivable ? this.ground() : nothing}
      <text class="axis" x=${WIDTH - EDGE} y=${height - 6} text-anchor="end" .textContent=${words(across!)}></text>
      ${up ? svg`<text class="axis" x="4" y="14" .textContent=${words(up)}></text>` : nothing}
      ${state.clips.map((clip) => this.point(clip, shares?.[clip], percent?.[clip]))} ${isDrivable ? this.cross() : nothing}
    </svg>`;
  }

  /** `share`: how much of the blend the clip has, 0…1; `percent`: as the pad says it. */
  private point(clip: string, share?: number, percent?: number): TemplateResult {
    const has = percent === undefined ? "" : `${percent} %`;
    const held = this.drag.value;
    const place = held?.clip === clip ? held.place : (this.state.points[clip] ?? []);
    return svg`<g class="clip" tabindex="0" role="button" data-clip=${clip} transform=${this.at(place)}
      aria-label=${`${clip}: ${this.told(place)}${has && `, ${has} of the blend`}; arrow keys move it`}
      @pointerdown=${(press: PointerEvent) => this.take(press, clip, place)}
      @pointermove=${(pointer: PointerEvent) => this.pull(pointer, clip)}
      @pointerup=${this.drop} @pointercancel=${this.drop}
      @keydown=${(press: KeyboardEvent) => this.step(press, clip, place)} @keyup=${this.drop}>
      <circle r="14" class="reach" /><circle r="6" /><circle r=${6 * Math.sqrt(share ?? 0)} class="share" />
      <text y="-11" text-anchor=${anchor(along(this.axes[0]!, place[0] ?? 0))}
        .textContent=${has ? `${clip} ${has}` : clip}></text>
    </g>`;
  }

  /** The whole pad drags the cross. */
  private ground(): TemplateResult {
    return svg`<rect class="ground" width=${WIDTH} height=${this.height}
      @pointerdown=${(press: PointerEvent) => this.take(press, null, this.placeAt(press))}
      @pointermove=${(pointer: PointerEvent) => this.pull(pointer, null)}
      @pointerup=${this.drop} @pointercancel=${this.drop} />`;
  }

  /** Drawn last: where it stands on a clip, the pointer takes the cross. */
  private cross(): TemplateResult {
    const { axes } = this;
    const place = this.values();
    return svg`<g class="cross" tabindex="0" role="button" transform=${this.at(clamped(axes, place))}
      aria-label=${`the blend at ${this.told(place)}; arrow keys move it`}
      @pointerdown=${(press: PointerEvent) => this.take(press, null, place)}
      @pointermove=${(pointer: PointerEvent) => this.pull(pointer, null)}
      @keydown=${(press: KeyboardEvent) => this.step(press, null, place)}>
      <circle r="10" class="grip" /><path d=${CROSS} />
    </g>`;
  }

  /** What the actor's parameters are set to. */
  private values(): number[] {
    return this.axes.map(({ name }) => this.app.parameters.get(name));
  }

  private at(place: Place): string {
    const [x, y] = this.axes.map((axis, i) => along(axis, place[i] ?? 0));
    const across = EDGE + x! * (WIDTH - 2 * EDGE);
    const down = y === undefined ? this.height / 2 : this.height - EDGE - y * (this.height - 2 * EDGE);
    return `translate(${across.toFixed(1)} ${down.toFixed(1)})`;
  }

  private placeAt({ currentTarget, clientX, clientY }: PointerEvent): number[] {
    const pad = (currentTarget as Element).closest("svg")!.getBoundingClientRect();
    const x = ((clientX - pad.left) / pad.width) * WIDTH;
    const y = ((clientY - pad.top) / pad.height) * this.height;
    const parts = [(x - EDGE) / (WIDTH - 2 * EDGE), (this.height - EDGE - y) / (this.height - 2 * EDGE)];
    return this.axes.map((axis, i) => valueAt(axis, parts[i]!));
  }

  private told(place: Place): string {
    return this.axes
      .map(({ name }, i) => `${name} ${valueAt(this.axes[i]!, along(this.axes[i]!, place[i] ?? 0))}`)
      .join(", ");
  }

  private take(press: PointerEvent, clip: string | null, place: Place): void {
    (press.currentTarget as Element).setPointerCapture(press.pointerId);
    this.move(clip, place);
  }

  private pull(pointer: PointerEvent, clip: string | null): void {
    if ((pointer.currentTarget as Element).hasPointerCapture(pointer.pointerId))
      this.move(clip, this.placeAt(pointer));
  }

  private step(press: KeyboardEvent, clip: string | null, place: Place): void {
    const next = stepped(this.axes, place, press.key);
    if (!next) return;
    press.preventDefault();
    this.move(clip, next);
  }

  /** Moves a clip on the pad alone; the cross moves the actor's parameters. */
  private move(clip: string | null, place: Place): void {
    if (clip !== null) this.drag.value = { clip, place };
    else this.axes.forEach(({ name }, i) => this.app.parameters.set(name, place[i]!));
  }

  /** Keeps where a clip was put; a refusal puts it back. */
  private readonly drop = async (): Promise<void> => {
    const held = this.drag.value;
    if (held?.clip == null) return;
    const before = this.state.points[held.clip];
    if (before?.join() !== held.place.join())
      await this.app.editing.operate(
        putClip({ state: this.state.name, layer: this.layer }, held.clip, held.place),
      );
    if (this.drag.value === held) this.drag.value = null;
  };
}

/** Returns on which side of a point its name has room. */
const anchor = (part: number): string => (part < 0.25 ? "start" : part > 0.75 ? "end" : "middle");

const words = ({ name, least, most }: Axis): string => `${name} ${least} … ${most}`;
