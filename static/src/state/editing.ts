/**
 * Edits the machine: tries and keeps cells, goes back one version, holds the newest version and its findings.
 */

import { signal } from "@preact/signals-core";
import * as api from "../net/api";
import type { Edited, MachineVersion, Finding, MachineInfo, NewCell, Operation } from "../net/protocol";
import { reasonOf } from "../net/reason";
import type { Event } from "./event";
import type { WatchedMachine } from "./watchedMachine";

/** The answer to an edit. `stale`: another editor was first, and the machine was read again. */
export interface Answer {
  kind: "fine" | "refused" | "stale";
  words: string;
  findings: Finding[];
}

/** A cell of a layer. */
export type CellPlace = Required<Omit<NewCell, "text">>;

/**
 * Returns the answer to a refused text: the verifier's findings, or one at the cell with the parser's words.
 */
export function refusal(words: string, findings: readonly Finding[], place: CellPlace): Answer {
  if (findings.length) return { kind: "refused", words, findings: [...findings] };
  const line = Number(/\bline (\d+)/.exec(words)?.[1] ?? 0);
  const message = words.replace(/^[^:]*\bline \d+: /, "");
  const { layer, state, event } = place;
  const finding = { kind: "refused", severity: "error" as const, message, line, layer, state, event };
  return { kind: "refused", words, findings: [{ ...finding, replay: [] }] };
}

export class Editing {
  /** The newest version of the machine that is shown. */
  readonly newest = signal<MachineVersion | null>(null);
  /** The verifier's findings about that version. */
  readonly findings = signal<readonly Finding[]>([]);
  private checked = "";

  constructor(
    private readonly machine: WatchedMachine,
    private readonly notices: Event<string>,
  ) {
    machine.info.subscribe((info) => {
      if (info) void this.look(info);
    });
  }

  private async look({ name, version }: MachineInfo): Promise<void> {
    const wanted = `${name} ${version}`;
    if (wanted === this.checked) return;
    this.checked = wanted;
    const [machineVersions, verified] = await Promise.all([
      api.versions(name).catch(() => []),
      api.verify(name).catch(() => null),
    ]);
    if (wanted !== this.checked) return;
    this.newest.value = machineVersions.at(-1) ?? null;
    this.findings.value = verified?.findings ?? [];
  }

  /** Plays every transition; adds what is over the machine's budgets to the findings. Returns it in words. */
  async measure(): Promise<string> {
    const machine = this.machine.info.value;
    if (!machine) return "the machine is not known yet";
    const { findings, measured, budgets } = await api.measure(machine.name);
    if (this.machine.info.value?.version === machine.version) {
      const others = this.findings.value.filter(({ kind }) => kind !== "budget");
      this.findings.value = [...others, ...findings];
    }
    const limits = Object.keys(budgets).length ? `${findings.length} over budget` : "the file has no budgets";
    return `${measured.length} transitions and motions measured, ${limits}`;
  }

  /** Keeps an edit, or only verifies it (`dry`). Throws errors other than a refusal or a conflict. */
  async cell(place: CellPlace, text: string, dry: boolean): Promise<Answer> {
    const machine = this.machine.info.value;
    if (!machine) return { kind: "refused", words: "the machine is not known yet", findings: [] };
    try {
      const edited = await api.patchCell(machine.name, machine.version, { ...place, text }, dry);
      if (edited.result === "refused") return refusal(edited.detail, edited.findings, place);
      if (!dry) this.take(edited);
      return { kind: "fine", words: "", findings: edited.findings };
    } catch (error) {
      if (!(error instanceof api.ApiError)) throw error;
      if (error.status !== 412) return refusal(error.message, error.findings, place);
      await this.reload(machine.name);
      return { kind: "stale", words: error.message, findings: [] };
    }
  }

  /** Keeps operations as one version. A refusal is shown as a notice; returns whether they are kept. */
  async operate(operations: Operation[]): Promise<boolean> {
    const machine = this.machine.info.value;
    if (!machine) return false;
    try {
      const edited = await api.patchMachine(machine.name, machine.version, operations, false);
      if (edited.result === "accepted") this.take(edited);
      return edited.result === "accepted";
    } catch (error) {
      const refused = error instanceof api.ApiError ? error : new api.ApiError(0, String(error));
      this.notices.emit(`Not kept: ${refused.findings[0]?.message ?? refused.message}`);
      if (refused.status === 412) await this.reload(machine.name);
      return false;
    }
  }

  /** Replaces the machine's expressions. Throws if they are refused, or the machine is newer. */
  async expressions(text: string): Promise<void> {
    const machine = this.machine.info.value;
    if (!machine) return;
    const edited = await api.patchExpressions(machine.name, machine.version, text);
    if (edited.result === "refused") throw new api.ApiError(422, edited.detail);
    this.take(edited);
  }

  /** Goes back to the version before; a refusal is shown as a notice. */
  async undo(): Promise<void> {
    const machine = this.machine.info.value;
    if (!machine) return;
    await api.undo(machine.name, machine.version).then(
      (edited) => this.take(edited),
      async (error: unknown) => {
        this.notices.emit(reasonOf(error));
        if (error instanceof api.ApiError && error.status === 412) await this.reload(machine.name);
      },
    );
  }

  private take(edited: Edited): void {
    this.machine.take(edited);
  }

  private async reload(name: string): Promise<void> {
    this.machine.take(await api.machine(name));
  }
}
