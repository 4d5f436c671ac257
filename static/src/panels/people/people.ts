/** Lists who watches the stage: names, rights, what they look at; follow another's camera, say your own name. */

import "../../ui/formField.css";
import "./people.css";
import { html, nothing, type TemplateResult } from "lit-html";
import type { Viewer } from "../../net/protocol";
import { draw } from "../../ui/draw";
import type { App } from "../../view/app";
import { nameOfViewer, placeWords, RIGHTS } from "./viewerWords";

/** The longest name that the server takes. */
const LONGEST_NAME = 40;

export function peoplePanel(host: HTMLElement, app: App): void {
  const { commands, inspection, people, stage } = app;
  commands.add({ keys: [], words: "people: who watches", act: () => (inspection.drawer.value = "people") });

  function rename(submit: SubmitEvent): void {
    submit.preventDefault();
    const field = host.querySelector<HTMLInputElement>("input")!;
    people.rename(field.value.trim());
  }

  const followButton = (viewer: Viewer): TemplateResult => {
    const isFollowed = people.following.value === viewer.id;
    return html`<button
      type="button"
      aria-pressed=${isFollowed}
      aria-label=${`follow the camera of ${nameOfViewer(viewer)}`}
      title="see from where this viewer looks"
      @click=${() => people.follow(isFollowed ? null : viewer.id)}
    >
      follow
    </button>`;
  };

  function row(viewer: Viewer): TemplateResult {
    const isSelf = viewer.id === people.self;
    const actors = (stage.hello.value?.casts ?? []).flatMap((cast) => cast.actors);
    return html`<li>
      <b .textContent=${nameOfViewer(viewer)}></b>
      <span .textContent=${isSelf ? `you · ${RIGHTS[viewer.role]}` : RIGHTS[viewer.role]}></span>
      <small .textContent=${placeWords(viewer, actors, people.all.value)}></small>
      ${isSelf ? nothing : followButton(viewer)}
    </li>`;
  }

  draw(
    host,
    () =>
      html`<form @submit=${rename}>
          <label for="own-name">your name</label>
          <input
            id="own-name"
            class="text-input"
            autocomplete="nickname"
            maxlength=${LONGEST_NAME}
            .defaultValue=${people.name.value}
          />
          <button type="submit">set</button>
        </form>
        <ul aria-label="viewers">
          ${people.all.value.map(row)}
        </ul>`,
  );
}
