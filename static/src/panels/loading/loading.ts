/** Says what is being loaded, or why the stage cannot be shown. */

import type { App } from "../../view/app";
import { say } from "../../ui/dom";

export function loadingPanel(host: HTMLElement, { view }: App): void {
  view.loading.subscribe((text) => say(host, text));
}
