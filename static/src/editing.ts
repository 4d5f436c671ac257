/** The machine as it is edited from this page: a cell tried, kept or refused, an undo, and which version this is. */

import * as api from "./net/api";
import type { Edited, Edition, Finding, MachineInfo } from "./net/protocol";
import type { Session } from "./session";
import { Signal } from "./store";

/** What the server says to an edit. `stale`: somebody else has edited; the machine was read again. */
export interface Answer {
  kind: "fine" | "refused" | "stale";
  words: string;
  findings: Finding[];
}

type Place = Omit<api.NewCell, "text">;

/** What is wrong with an edit, as findings: the verifier's, or the reader's own words at the cell. */
export function refusal(error: api.ApiError, { layer, state, event }: Place): Finding[] {
  if (error.findings.length) return [...error.findings];
  const line = Number(/\bline (\d+)/.exec(error.message)?.[1] ?? 0);
  const message = error.message.replace(/^[^:]*\bline \d+: /, "");
  return [{ kind: "refused", severity: "error", message, line, layer, state, event }];
}

export class Editing {
  /** The newest version of the machine that is shown. */
  readonly edition = new Signal<Edition | null>(null);
  /** What the verifier says of it. */
  readonly findings = new Signal<readonly Finding[]>([]);
  private checked = "";

  constructor(private readonly session: Session) {
    session.machine.on((machine) => machine && void this.look(machine));
  }

  /** Reads what is known of a version, once. */
  private async look({ name, version }: MachineInfo): Promise<void> {
    const wanted = `${name} ${version}`;
    if (wanted === this.checked) return;
    this.checked = wanted;
    const [editions, verified] = await Promise.all([api.versions(name).catch(() => []), api.verify(name).catch(() => null)]);
    if (wanted !== this.checked) return;
    this.edition.set(editions.at(-1) ?? null);
    this.findings.set(verified?.findings ?? []);
  }

  /** Asks what an edit would be (`dry`), or makes it. Throws what is neither a refusal nor a conflict. */
  async cell(place: Place, text: string, dry: boolean): Promise<Answer> {
    const machine = this.session.machine.value;
    if (!machine) return { kind: "refused", words: "the machine is not known yet", findings: [] };
    try {
      const edited = await api.patchCell(machine.name, machine.version, { ...place, text }, dry);
      if (!dry) this.take(edited);
      return { kind: "fine", words: "", findings: edited.findings };
    } catch (error) {
      if (!(error instanceof api.ApiError)) throw error;
      if (error.status !== 412) return { kind: "refused", words: error.message, findings: refusal(error, place) };
      await this.reload(machine.name);
      return { kind: "stale", words: error.message, findings: [] };
    }
  }

  /** Goes back to the version before; what cannot be is said in a notice. */
  async undo(): Promise<void> {
    const machine = this.session.machine.value;
    if (!machine) return;
    await api.undo(machine.name, machine.version).then(
      (edited) => this.take(edited),
      async (error: Error) => {
        this.session.notices.ring(error.message);
        if (error instanceof api.ApiError && error.status === 412) await this.reload(machine.name);
      },
    );
  }

  private take(edited: Edited): void {
    this.session.takeMachine(edited);
  }

  private async reload(name: string): Promise<void> {
    this.session.takeMachine(await api.machine(name));
  }
}
