"""A machine folder made from a model: a state for each clip, an event for each state, a complete table, keys."""

from __future__ import annotations

import csv
import io
import json
import os
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from statwalk.character import Character
from statwalk.errors import ContentError, MachineError
from statwalk.files import clipnames, faqnames
from statwalk.files.machinefile import FILE_NAME
from statwalk.motion.clip import Clip

TABLE_NAME = "table.csv"
LARGEST_INLINE = 20
"""states; a larger table goes into a file of its own, for a spreadsheet"""
CLOSE = 1e-2
PLAIN = re.compile(r"[^\W\d][\w.-]*")
SHORT_KEYS = "qwertyuioasdhjkzxcvbnm567890"
"""without those that the viewer has for itself"""


@dataclass(frozen=True)
class Motion:
    """A clip with its state, its event and its kind.

    No event asks for the idle motion, nor for one that comes of itself: `after` is the state that the end of this one leads to
    (else the idle one), `door` the state that is passed on the way into this one.
    """

    clip: str
    state: str
    event: str
    kind: clipnames.Kind
    after: str = ""
    door: str = ""


def write_machine(character: Character, source: Path, folder: Path, copy: bool = True) -> Path:
    """Writes the folder and returns it; with `copy` the model goes into it, else its path is named.

    Raises MachineError where the folder holds a machine already, or the model has no clips.
    """
    if (folder / FILE_NAME).exists():
        raise MachineError("there is a machine here already; choose another folder", file=str(folder / FILE_NAME))
    model = Path(f"{source.stem}.glb") if copy else Path(os.path.relpath(source.resolve(), folder.resolve()))
    write_folder(source.stem, motions_of(character), model, folder)
    if copy:
        (folder / model).write_bytes(character.model_glb)
    return folder


def write_folder(title: str, motions: list[Motion], model: Path, folder: Path) -> None:
    """Writes the machine file, and a large table beside it; nothing is written before the text is made."""
    inline = len(motions) <= LARGEST_INLINE
    text = machine_text(title, motions, model, inline)
    folder.mkdir(parents=True, exist_ok=True)
    if not inline:
        (folder / TABLE_NAME).write_text(as_csv(table_of(motions)), encoding="utf-8", newline="")
    (folder / FILE_NAME).write_text(text, encoding="utf-8")


def kinds_of(character: Character) -> dict[str, clipnames.Kind]:
    """The kind of each clip; raises ContentError where there are none."""
    if not character.clips:
        raise ContentError("the model has no animations, so there are no states to make", file=character.name)
    return {name: clipnames.kind(name, clip.duration, comes_round(clip)) for name, clip in character.clips.items()}


def idle_of(kinds: Mapping[str, clipnames.Kind]) -> str:
    """The clip that suits standing about best."""
    return min(kinds, key=lambda name: (*clipnames.idle_rank(name)[:1], kinds[name] != "loop", clipnames.idle_rank(name)[1]))


def named_motions(character: Character, states: Mapping[str, str]) -> list[Motion]:
    """The motions of some clips, under given names of states; the one called STAT, else the best suited, is idle and comes first.

    Raises ContentError where the model has no animations, UnknownNameError for what is none of them.
    """
    kinds = kinds_of(character)
    for clip in states:
        character.clip(clip)
    chosen = {clip: kinds[clip] for clip in states}
    idle = next((clip for clip, state in states.items() if state == "STAT"), "") or idle_of(chosen)
    found: list[Motion] = []
    for clip in sorted(states, key=lambda clip: clip != idle):
        state, names = states[clip], states.values()
        after, asked = faqnames.follower(state, names), "" if clip == idle else faqnames.event_of(state, names)
        event = clipnames.distinct(asked, ["STOP", "END", "STATE", *(one.event for one in found)]) if asked else ""
        kind: clipnames.Kind = "once" if after or not asked else kinds[clip]
        goes_on = clip == idle or state in faqnames.LOOPS
        found.append(Motion(clip, state, event, "loop" if goes_on else kind, after, faqnames.door(state, names)))
    return found


def motions_of(character: Character) -> list[Motion]:
    """The motions under the names that are proposed for their clips, the idle one first; raises ContentError where there are none."""
    return named_motions(character, faqnames.proposed(character.clips))


def comes_round(clip: Clip) -> bool:
    """Whether the last pose is the first again, though it moves in between."""
    first, middle, last = (clip.sample(clip.duration * part) for part in (0.0, 0.4, 1.0))

    def near(a: np.ndarray, b: np.ndarray) -> bool:
        return bool(np.abs(a - b).max(initial=0.0) < CLOSE)

    turned = np.abs(first.rotation * last.rotation).sum(-1)  # |q·p| >= this only where they agree; sign does not matter
    same = near(first.translation, last.translation) and near(turned, np.maximum(turned, 1 - CLOSE / 10))
    moves = not (near(first.translation, middle.translation) and near(first.rotation, middle.rotation))
    return same and moves


def table_of(motions: list[Motion]) -> list[list[str]]:
    """The complete table, header first: what goes on can be left at once, what comes once or rests is left at its end."""
    idle = motions[0]
    asked = [one for one in motions if one.event]
    rows = [["state", *(one.event for one in asked), "STOP", "END"]]
    for here in motions:
        cells = [cell(here, there) for there in asked]
        end = {"loop": here.state, "once": here.after or idle.state, "rest": "-"}[here.kind]
        rows.append([here.state, *cells, stop(here, idle), end])
    return rows


def stop(here: Motion, idle: Motion) -> str:
    """Where STOP leads from a state: through the idle state's door from the walk and the way into it."""
    if here.state in ("WALK", "STWK"):
        return idle.door or idle.state
    if here.after:
        return ""
    return idle.state if here.kind == "loop" else f"{idle.state} at end"


def cell(here: Motion, there: Motion) -> str:
    """Where an event leads from a state; what goes on by itself lets events wait."""
    if here.after and here.state != "CSTP":
        return ""
    if here.state == there.state:
        return f"{there.state}! at end" if here.kind == "once" else there.state
    at_once = here.kind == "loop" or there.kind != "loop"
    target = there.door or there.state
    return target if at_once else f"{target} at end"


def as_csv(rows: list[list[str]]) -> str:
    """The table for a spreadsheet."""
    text = io.StringIO()
    csv.writer(text).writerows(rows)
    return text.getvalue()


def as_text(rows: list[list[str]]) -> str:
    """The table in columns, with `|` between them."""
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    return "\n".join("  " + " | ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip() for row in rows)


def quoted(text: str) -> str:
    """The text as YAML reads it back, with what cannot be seen written out."""
    if PLAIN.fullmatch(text):
        return text
    return "".join(one if one.isprintable() else f"\\U{ord(one):08x}" for one in json.dumps(text, ensure_ascii=False))


def machine_text(title: str, motions: list[Motion], model: Path, inline: bool) -> str:
    """The machine file."""
    lines = [
        f"# Made by `statwalk new` from {quoted(model.name)}: a state for each clip. Edit it, then `statwalk verify`.",
        "semantics: 1",
        f"title: {quoted(title)}",
        f"character: {quoted(str(model))}",
        f"initial: {motions[0].state}",
        "defaults: {when: now, blend: 0.2, buffer: 0.3}",
        "",
        "# Loops go on until an event says otherwise; the others come to an end.",
        "states:",
        *(f"  {quoted(one.state)}: {{motion: {quoted(one.clip)}, loop: {str(one.kind == 'loop').lower()}}}" for one in motions),
        "",
        "# The next state, for each state (down) and event (across). STOP and the END of what comes once lead to the idle state.",
        f"table: {'|' if inline else TABLE_NAME}",
        *([as_text(table_of(motions))] if inline else []),
        "",
        "keys:",
        *(f"  {quoted(key)}: {sent}" for key, sent in keys(motions)),
    ]
    return "\n".join(lines) + "\n"


def keys(motions: list[Motion]) -> Iterator[tuple[str, str]]:
    """Arrows and Shift, held, for what goes somewhere; Space for a jump; digits and letters for the rest; Escape for STOP."""
    left = {one.event: one for one in motions if one.event}
    for key, kind, stems, event in SPECIAL_KEYS:
        found = [one for one in left.values() if one.event == event or (one.kind == kind and clipnames.says(one.clip, stems))]
        if found:
            best = min(found, key=lambda one: (one.event != event, len(clipnames.words(one.clip))))
            del left[best.event]
            yield key, f"{{hold: {best.event}, release: STOP}}" if best.kind == "loop" else f"{{press: {best.event}}}"
    for key, event in zip(SHORT_KEYS, left, strict=False):
        yield key, f"{{press: {event}}}"
    yield "Escape", "{press: STOP}"


SPECIAL_KEYS: tuple[tuple[str, clipnames.Kind, str, str], ...] = (
    ("ArrowUp", "loop", "walk trot", "FORWARD"),
    ("Shift", "loop", "run jog sprint gallop", "RUN"),
    ("ArrowDown", "loop", "back crouch sneak", "CROUCH"),
    ("ArrowLeft", "loop", "left", "LEFT"),
    ("ArrowRight", "loop", "right", "RIGHT"),
    ("Space", "once", "jump", "JUMP"),
)
"""key, the kind and the words of the clips that suit it, and the event that suits it best"""
