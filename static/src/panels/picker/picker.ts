/** Picks the machine or scene to watch, and the actor. */

import "./picker.css";
import * as api from "../../net/api";
import type { Opening, OwnStages } from "../../state/ownStages";
import type { Session } from "../../state/session";
import { el } from "../../ui/dom";

/** Marks a scene's name in the list; names of machines have no colon. */
const SCENE = "scene:";

export class Picker {
  private readonly machines = el("select", { "aria-label": "machine", title: "machine" });
  private readonly actors = el("select", { "aria-label": "actor", title: "actor" });
  /** The scene of each machine, or empty. */
  private scenes = new Map<string, string>();

  constructor(
    host: HTMLElement,
    private readonly session: Session,
    private readonly stages: OwnStages,
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
    const [machines, scenes] = await Promise.all([
      api.machines().catch(() => []),
      api.scenes().catch(() => []),
    ]);
    const alone = machines
      .filter(({ scene }) => !scene)
      .map(({ name, title }) => el("option", { value: name }, title ?? name));
    const furnished = scenes.map(({ name, title, description }) =>
      el("option", { value: SCENE + name, title: description }, title),
    );
    const group = furnished.length ? [el("optgroup", { label: "scenes" }, ...furnished)] : [];
    this.scenes = new Map(machines.map(({ name, scene }) => [name, scene]));
    this.machines.replaceChildren(el("optgroup", { label: "machines" }, ...alone), ...group);
    this.machines.hidden = !this.machines.options.length; // a link to one stage lists no others
    this.select();
  }

  private select(): void {
    const name = this.session.cast?.machine;
    const scene = this.scenes.get(name ?? "");
    if (name !== undefined) this.machines.value = scene ? SCENE + scene : name;
    this.actors.value = String(this.session.actor.value);
  }

  private async show(): Promise<void> {
    const actors = this.session.hello.value?.casts.flatMap((cast) => cast.actors) ?? [];
    this.actors.hidden = actors.length < 2;
    this.actors.replaceChildren(...actors.map(({ id, name }) => el("option", { value: id }, name)));
    this.select();
    if (!this.machines.options.length) await this.list();
  }

  /** Lists the machines again and watches a new one. */
  async open(machine: string): Promise<void> {
    await this.list();
    await this.choose(machine);
  }

  /** Watches a machine or scene: on the main stage if it plays there, else on a new stage. */
  private async choose(what: string): Promise<void> {
    const opening: Opening = what.startsWith(SCENE) ? { scene: what.slice(SCENE.length) } : { machine: what };
    await this.session.command(() => this.stages.choose(opening, this.playsOnMain(what)));
  }

  private async playsOnMain(what: string): Promise<boolean> {
    const main = await api.stage("main").catch(() => null);
    return !!main?.actors.some(
      ({ machine }) => machine === what || SCENE + this.scenes.get(machine) === what,
    );
  }
}
