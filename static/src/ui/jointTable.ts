/** A table of joints: how far each is apart in what is compared. */

import "./jointTable.css";
import { html, nothing, type TemplateResult } from "lit-html";

export interface JointLine {
  joint: string;
  /** Centimetres. */
  distance: string;
  /** Degrees. */
  angle: string;
}

export function jointTable(lines: readonly JointLine[]): TemplateResult | typeof nothing {
  if (!lines.length) return nothing;
  return html`<table class="joint-table">
    <thead>
      <tr>
        <th scope="col">joint</th>
        <th scope="col">cm</th>
        <th scope="col">degrees</th>
      </tr>
    </thead>
    <tbody>
      ${lines.map(
        ({ joint, distance, angle }) =>
          html`<tr>
            <th scope="row" .textContent=${joint}></th>
            <td .textContent=${distance}></td>
            <td .textContent=${angle}></td>
          </tr>`,
      )}
    </tbody>
  </table>`;
}
