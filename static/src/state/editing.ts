/**
 * Edits the machine: tries and keeps changes, goes back and forth through its versions, holds the newest version and
 * its findings.
 */

import { batch, computed, signal } from "@preact/signals-core";
import * as api from "../net/api";
import * as edits from "../net/edits";
import { isUnheard } from "../net/once";
import type { Edited, Finding, MachineInfo, MachineVersion, Operation } from "../net/protocol";
import { reasonOf } from "../net/reason";
import { EditQueue } from "./editQueue";
import { type Answer, type CellPlace, refusal } from "./editAnswer";
import { Event } from "./event";
import type { Notice } from "./notice";
import type { WatchedMachine } from "./watchedMachine";

const REST_MS = 700;

/** A change of a machine that makes one version: operations, or a whole text in place of that of `version`. */
export type Edit = { machine: string; operations: readonly Operation[] } | TextEdit;

interface TextEdit {
  machine: string;
  text: string;
  version: number;
}

export class Editing {
  /** The versions of the machine that is shown, oldest first. */
  readonly versions = signal<readonly MachineVersion[]>([]);
  readonly newest = computed(() => this.versions.value.at(-1) ?? null);
  /**
   * The verifier's findings about the newest version, until the verifier answers about the version before; null: the
   * verifier has not answered about this machine.
   */
  readonly verified = signal<readonly Finding[] | null>(null);
  readonly findings = computed(() => this.verified.value ?? []);
  readonly queue: EditQueue<Edit, Answer>;
  /** Emitted with the operations of each edit of the shown machine that is kept. */
  readonly kept = new Event<readonly Operation[]>();
  /** The versions that texts of this page made, by the machine and the version before. */
  private readonly followers = new Map<string, number>();
  private checked = "";
  private checking = new AbortController();

  constructor(
    private readonly machine: WatchedMachine,
    private readonly notices: Event<Notice>,
    storage: Pick<Storage, "getItem" | "setItem"> = sessionStorage,
  ) {
    this.queue = new EditQueue({
      send: (edit, key) => this.send(edit, key),
      unheard: isUnheard,
      rest: () => new Promise((done) => setTimeout(done, REST_MS)),
      storage,
    });
    machine.answered = () => this.queue.next(() => Promise.resolve());
    machine.info.subscribe((info) => {
      if (info) void this.look(info);
    });
    this.queue.resume((answer) => void this.tell(answer));
  }

  private async look({ name, version }: MachineInfo): Promise<void> {
    const wanted = `${name} ${version}`;
    if (wanted === this.checked) return;
    this.abandon();
    if (!this.checked.startsWith(`${name} `)) this.verified.value = null;
    this.checked = wanted;
    const [versions, verified] = await Promise.all([
      edits.versions(name).catch(() => []),
      api.verify(name, this.checking.signal).catch(() => null),
    ]);
    if (wanted !== this.checked) return;
    this.versions.value = versions;
    this.verified.value = verified?.findings ?? null;
  }

  /** Gives up the check that runs: its machine is no longer shown, or is about to go. */
  abandon(): void {
    this.checking.abort();
    this.checking = new AbortController();
  }

  /** Plays every transition; adds what is over the machine's budgets to the findings. Returns it in words. */
  async measure(): Promise<string> {
    const machine = this.machine.info.value;
    if (!machine) return "the machine is not known yet";
    const { findings, measured, budgets } = await api.measure(machine.name);
    const { verified } = this;
    if (verified.value && this.machine.info.value?.version === machine.version)
      verified.value = [...verified.value.filter(({ kind }) => kind !== "budget"), ...findings];
    const limits = Object.keys(budgets).length ? `${findings.length} over budget` : "the file has no budgets";
    return `${measured.length} transitions and motions measured, ${limits}`;
  }

  /** Verifies operations without keeping them; returns null if a newer request follows. */
  try(operations: readonly Operation[]): Promise<Answer | null> {
    return this.queue.try({ machine: this.name, operations });
  }

  /** Keeps operations as one version. */
  keep(operations: readonly Operation[]): Promise<Answer> {
    return this.queue.keep({ machine: this.name, operations });
  }

  /** Keeps operations as one version. A refusal is shown as a notice; returns whether they are kept. */
  operate(operations: readonly Operation[]): Promise<boolean> {
    return this.tell(this.keep(operations));
  }

  /** Tries or keeps a whole text of the machine file, in place of that of `version`. */
  text(text: string, version: number, dry: boolean): Promise<Answer | null> {
    const edit = { machine: this.name, text, version };
    return dry ? this.queue.try(edit) : this.queue.keep(edit);
  }

  undo(): Promise<void> {
    return this.step((name, version) => edits.undo(name, version));
  }

  redo(): Promise<void> {
    return this.step((name, version) => edits.redo(name, version));
  }

  restore(number: number): Promise<void> {
    return this.step((name, version) => edits.restore(name, version, number));
  }

  private get name(): string {
    return this.machine.info.value?.name ?? "";
  }

  /** Goes to another version, after all edits that wait; a refusal is shown as a notice. */
  private step(request: (name: string, version: number) => Promise<Edited>): Promise<void> {
    return this.queue.next(async () => {
      const { name, version } = this.machine.info.value ?? { name: "", version: 0 };
      await request(name, version).then(
        (edited) => this.machine.take(edited),
        async (error: unknown) => {
          this.notices.emit(reasonOf(error));
          if (error instanceof api.ApiError && error.status === 412) await this.reload(name);
        },
      );
    });
  }

  private async tell(answer: Promise<Answer>): Promise<boolean> {
    const { kind, words, findings } = await answer.catch((error: unknown): Answer => ({
      kind: "refused",
      words: reasonOf(error),
      findings: [],
    }));
    if (kind !== "fine") this.notices.emit(`Not kept: ${findings[0]?.message ?? words}`);
    return kind === "fine";
  }

  /** Sends an edit, or (`key` is null) tries it. Throws errors other than a refusal or a conflict. */
  private async send(edit: Edit, key: string | null): Promise<Answer> {
    try {
      const edited = await this.sent(edit, key);
      if (edited.result === "refused") return refusal(edited.detail, edited.findings, placeOf(edit));
      if (key !== null && edited.name === this.name) this.take(edited, edit);
      return { kind: "fine", words: "", findings: edited.findings };
    } catch (error) {
      if (!(error instanceof api.ApiError) || isUnheard(error)) throw error;
      if (error.status !== 412) return refusal(error.message, error.findings, placeOf(edit));
      await this.reload(edit.machine);
      return { kind: "stale", words: error.message, findings: [] };
    }
  }

  /** Shows the edited machine; what follows its names does so at once. */
  private take(edited: Edited, edit: Edit): void {
    batch(() => {
      this.machine.take(edited);
      if ("operations" in edit) this.kept.emit(edit.operations);
    });
  }

  private async sent(edit: Edit, key: string | null) {
    if ("text" in edit) return this.sentText(edit, key);
    const known = this.machine.info.value;
    const { version } = known?.name === edit.machine ? known : await api.machine(edit.machine);
    return edits.patchMachine(edit.machine, version, edit.operations, key);
  }

  private async sentText({ machine, text, version }: TextEdit, key: string | null) {
    const before = this.followed(machine, version);
    const edited = await edits.putMachine(machine, before, text, key);
    if (key !== null && edited.result !== "refused")
      this.followers.set(`${machine} ${before}`, edited.version);
    return edited;
  }

  /**
   * Returns the version that a text takes the place of: its own, or, if an earlier text of this page was still on its
   * way when this one was typed, the version that the earlier one made.
   */
  private followed(machine: string, version: number): number {
    const known = this.machine.info.value;
    const isNewest = known?.name === machine && known.version === version;
    const follower = isNewest ? undefined : this.followers.get(`${machine} ${version}`);
    return follower === undefined ? version : this.followed(machine, follower);
  }

  private async reload(name: string): Promise<void> {
    this.machine.take(await api.machine(name));
  }
}

/** Returns the cell that an edit changes, if it changes one. */
function placeOf(edit: Edit): CellPlace | null {
  const operation = "operations" in edit ? edit.operations[0] : undefined;
  if (operation?.kind !== "set_cell") return null;
  const { layer = "base", state, event } = operation;
  return { layer, state, event };
}
