/** The button that closes the dialog around it. */

import { html } from "lit-html";

const close = ({ target }: Event): void => (target as HTMLElement).closest("dialog")?.close();

export const closeButton = html`<button
  type="button"
  class="plain close"
  aria-label="esc: close"
  @click=${close}
>
  esc
</button>`;
