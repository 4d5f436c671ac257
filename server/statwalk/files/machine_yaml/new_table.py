"""Makes the complete table of a machine from a model's motions: a row for each motion, a column for each
event.
"""

from __future__ import annotations

import csv
import io
from dataclasses import dataclass

from statwalk.files.machine_yaml import clip_names


@dataclass(frozen=True)
class Motion:
    """A clip with its state, its event and its kind.

    The clip is empty for the pose at rest. The idle motion has no event; a motion that only follows another
    one has none either. `after` is the state that the end of this motion leads to (empty: the idle state);
    `entry_state` is the state that is passed on the way into this one. `is_on_the_spot`: the clip is a walk
    on the spot.
    """

    clip: str
    state: str
    event: str
    kind: clip_names.Kind
    after: str = ""
    entry_state: str = ""
    is_on_the_spot: bool = False


def table_of(motions: list[Motion]) -> list[list[str]]:
    """Returns the complete table, header first: a loop can be left at once, other motions are left at their
    end.
    """
    idle = motions[0]
    requestable = [motion for motion in motions if motion.event]
    rows = [["state", *(motion.event for motion in requestable), "STOP", "END"]]
    for current in motions:
        cells = [event_cell(current, next_motion) for next_motion in requestable]
        end = {"loop": current.state, "once": current.after or idle.state, "rest": "-"}[current.kind]
        rows.append([current.state, *cells, stop_cell(current, idle), end])
    return rows


def stop_cell(motion: Motion, idle: Motion) -> str:
    """Returns the cell of STOP: WALK and STWK stop through the entry state of the idle state."""
    if motion.state in ("WALK", "STWK"):
        return idle.entry_state or idle.state
    if motion.after:
        return ""
    return idle.state if motion.kind == "loop" or motion == idle else f"{idle.state} at end"


def event_cell(motion: Motion, next_motion: Motion) -> str:
    """Returns the cell of the event of `next_motion`; blank if the motion ends by itself, so that the event
    waits.
    """
    if motion.after and motion.state != "CSTP":
        return ""
    if motion.state == next_motion.state:
        return f"{next_motion.state}! at end" if motion.kind == "once" else next_motion.state
    at_once = motion.kind == "loop" or next_motion.kind != "loop"
    target = next_motion.entry_state or next_motion.state
    return target if at_once else f"{target} at end"


def as_csv(rows: list[list[str]]) -> str:
    """Returns the table as CSV, for a spreadsheet."""
    text = io.StringIO()
    csv.writer(text).writerows(rows)
    return text.getvalue()


def as_text(rows: list[list[str]]) -> str:
    """Returns the table in columns, with `|` between them."""
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    return "\n".join(
        "  " + " | ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()
        for row in rows
    )
