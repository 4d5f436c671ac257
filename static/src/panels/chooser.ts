/** Which machine is watched: the stage that has it already, else a new stage of one's own; and which actor of several. */

import * as api from "../net/api";
import type { Session } from "../session";
import { el } from "./dom";

export class Chooser {
  private readonly machines = el("select", { "aria-label": "machine", title: "machine" });
  private readonly actors = el("select", { "aria-label": "actor", title: "actor" });
  /** The stage this page opened for itself, if it did. */
  private own: string | null = null;

  constructor(
    host: HTMLElement,
    private readonly session: Session,
  ) {
    host.append(this.machines, this.actors);
    this.machines.addEventListener("change", () => void this.choose(this.machines.value));
    this.actors.addEventListener("change", () => {
      session.actor.set(Number(this.actors.value));
      void session.loadMachine();
    });
    session.hello.on(() => void this.show());
    session.machine.on(() => this.select());
    session.actor.on(() => this.select());
    void this.list();
  }

  private async list(): Promise<void> {
    const machines = await api.machines().catch(() => []);
    this.machines.replaceChildren(...machines.map(({ name, title }) => el("option", { value: name }, title ?? name)));
    this.select();
  }

  private select(): void {
    const name = this.session.cast?.machine;
    if (name !== undefined) this.machines.value = name;
    this.actors.value = String(this.session.actor.value);
  }

  private async show(): Promise<void> {
    const actors = this.session.hello.value?.casts.flatMap((cast) => cast.actors) ?? [];
    this.actors.hidden = actors.length < 2;
    this.actors.replaceChildren(...actors.map(({ id, name }) => el("option", { value: id }, name)));
    this.select();
    if (!this.machines.options.length) await this.list();
  }

  /** Takes up a machine that was just made, and watches it. */
  async open(machine: string): Promise<void> {
    await this.list();
    await this.choose(machine);
  }

  /** Watches `machine`: on the main stage if it is there, else on a stage made for it. */
  private async choose(machine: string): Promise<void> {
    const left = this.own;
    await this.session.command(async () => {
      const main = await api.stage("main").catch(() => null);
      const shared = main?.actors.some((actor) => actor.machine === machine) ?? false;
      this.own = shared ? null : await api.newStage(machine);
      this.session.watch(this.own ?? "main");
      if (left !== null) await api.remove(left);
    });
  }
}
