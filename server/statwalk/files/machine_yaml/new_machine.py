"""Makes a machine folder from a model: a state for each clip, an event for each state, a complete table,
keys. A model without clips gets one state, its pose at rest.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterator, Mapping
from pathlib import Path

import numpy as np

from statwalk.character.character import Character
from statwalk.character.feet import feet_of
from statwalk.character.foot_contacts import contacts_of
from statwalk.errors import MachineError
from statwalk.files.machine_yaml import clip_names, state_names
from statwalk.files.machine_yaml.machine_file import FILE_NAME
from statwalk.files.machine_yaml.new_table import Motion, as_csv, as_text, table_of
from statwalk.motion.clip import Clip

TABLE_NAME = "table.csv"
LARGEST_INLINE = 20
"""most states of an inline table; a larger table becomes a .csv file, for a spreadsheet"""
CLOSE = 1e-2
AT_REST = Motion("", "STAT", "", "rest")
"""the only motion of a model without clips: its pose at rest"""
PLAIN = re.compile(r"[^\W\d][\w.-]*")
SHORT_KEYS = "qwertyuioasdhjkzxcvbnm567890"
"""keys for events; the viewer's own keys are left out"""


def write_machine(character: Character, source: Path, folder: Path, copy: bool = True) -> Path:
    """Writes a machine folder and returns its path; with `copy` the model is copied into it, otherwise the
    machine file names the model's path.

    :raises MachineError: when the folder already holds a machine.
    """
    if (folder / FILE_NAME).exists():
        raise MachineError(
            "this folder already holds a machine; choose another folder", file=str(folder / FILE_NAME)
        )
    model = Path(f"{source.stem}.glb") if copy else Path(os.path.relpath(source.resolve(), folder.resolve()))
    write_folder(source.stem, motions_of(character), model, folder)
    if copy:
        (folder / model).write_bytes(character.model_glb)
    return folder


def write_folder(title: str, motions: list[Motion], model: Path, folder: Path, root: str = "") -> None:
    """Writes the machine file, and a large table beside it; nothing is written before the text is
    complete. `title`; "": the machine is called by its name. `root`: the joint that moves the character
    through the world; "": none.
    """
    inline = len(motions) <= LARGEST_INLINE
    text = machine_text(title, motions, model, inline, root)
    folder.mkdir(parents=True, exist_ok=True)
    if not inline:
        (folder / TABLE_NAME).write_text(as_csv(table_of(motions)), encoding="utf-8", newline="")
    (folder / FILE_NAME).write_text(text, encoding="utf-8")


def _kinds_of(character: Character) -> dict[str, clip_names.Kind]:
    return {
        name: clip_names.kind(name, clip.duration, _comes_round(clip))
        for name, clip in character.clips.items()
    }


def _idle_of(kinds: Mapping[str, clip_names.Kind]) -> str:
    """Returns the clip that suits best as idle motion."""
    return min(
        kinds,
        key=lambda name: (
            *clip_names.idle_rank(name)[:1],
            kinds[name] != "loop",
            clip_names.idle_rank(name)[1],
        ),
    )


def idle_clip(character: Character) -> str:
    """Returns the clip of a character that suits best as idle motion."""
    return _idle_of(_kinds_of(character))


def named_motions(character: Character, states: Mapping[str, str]) -> list[Motion]:
    """Returns the motions of the clips in `states`, with the names of their states; the idle motion comes
    first.

    The idle motion is the clip of the state STAT, or the clip that suits best; the pose at rest if the model
    has no clips.

    :raises UnknownNameError: when the model has no clip of a name.
    """
    if not character.clips and not states:
        return [AT_REST]
    kinds = _kinds_of(character)
    for clip in states:
        character.clip(clip)
    chosen = {clip: kinds[clip] for clip in states}
    contacts = contacts_of(character, feet_of(character))
    idle = next((clip for clip, state in states.items() if state == "STAT"), "") or _idle_of(chosen)
    motions: list[Motion] = []
    for clip in sorted(states, key=lambda clip: clip != idle):
        state, names = states[clip], states.values()
        next_state, wanted_event = (
            state_names.next_state(state, names),
            "" if clip == idle else state_names.event_of(state, names),
        )
        event = (
            clip_names.unused_name(
                wanted_event, ["STOP", "END", "STATE", *(motion.event for motion in motions)]
            )
            if wanted_event
            else ""
        )
        kind: clip_names.Kind = "once" if next_state or not wanted_event else kinds[clip]
        repeats = clip == idle or state in state_names.LOOPS
        motions.append(
            Motion(
                clip,
                state,
                event,
                "loop" if repeats else kind,
                next_state,
                state_names.entry_state(state, names),
                any(contacts[clip].drift),
            )
        )
    return motions


def motions_of(character: Character) -> list[Motion]:
    """Returns the motions of all clips under their proposed state names, the idle motion first."""
    return named_motions(character, state_names.proposed(character.clips))


def _comes_round(clip: Clip) -> bool:
    """Returns whether the last pose is the first pose again, and a pose in between differs."""
    first, middle, last = (clip.sample(clip.duration * part) for part in (0.0, 0.4, 1.0))

    def near(a: np.ndarray, b: np.ndarray) -> bool:
        return bool(np.abs(a - b).max(initial=0.0) < CLOSE)

    agreement = np.abs(first.rotation * last.rotation).sum(
        -1
    )  # |q·p|, near 1 if both rotations agree; the sign does not matter
    closes = near(first.translation, last.translation) and near(
        agreement, np.maximum(agreement, 1 - CLOSE / 10)
    )
    closes = closes and near(first.weights, last.weights)
    moves = not all(near(*pair) for pair in zip(first, middle, strict=True))
    return closes and moves


def quoted(text: str) -> str:
    """Returns the text as YAML reads it back; unprintable characters are escaped."""
    if PLAIN.fullmatch(text):
        return text
    return "".join(
        letter if letter.isprintable() else f"\\U{ord(letter):08x}"
        for letter in json.dumps(text, ensure_ascii=False)
    )


def machine_text(title: str, motions: list[Motion], model: Path, inline: bool, root: str = "") -> str:
    """Returns the text of the machine file."""
    lines = [
        "# Made by statwalk. Edit it, then `statwalk verify`.",
        "semantics: 1",
        *([f"title: {quoted(title)}"] if title else []),
        f"character: {quoted(str(model))}",
        *([f"root: {quoted(root)}"] if root else []),
        f"initial: {motions[0].state}",
        "defaults: {when: now, blend: 0.2, buffer: 0.3}",
        "",
        "# Loops repeat until an event ends them; all other motions end."
        if motions != [AT_REST]
        else "# The model has no animations: this is its pose at rest. Expressions can move it.",
        "states:",
        *(f"  {quoted(motion.state)}: {_motion_text(motion)}" for motion in motions),
        "",
        "# The next state, for each state (down) and event (across). STOP, and the END of motions that "
        "do not loop, lead to the idle state.",
        f"table: {'|' if inline else TABLE_NAME}",
        *([as_text(table_of(motions))] if inline else []),
        "",
        "keys:",
        *(f"  {quoted(key)}: {binding}" for key, binding in keys(motions)),
    ]
    return "\n".join(lines) + "\n"


def _motion_text(motion: Motion) -> str:
    if motion == AT_REST:
        return '{motion: {expressions: ""}}'
    ground_speed = ", ground_speed: found" if motion.is_on_the_spot and motion.kind == "loop" else ""
    return f"{{motion: {quoted(motion.clip)}, loop: {str(motion.kind == 'loop').lower()}{ground_speed}}}"


def keys(motions: list[Motion]) -> Iterator[tuple[str, str]]:
    """Yields keys and their bindings: arrows and Shift, held, for locomotion; Space for a jump; letters and
    digits for the rest; Escape for STOP.
    """
    unbound = {motion.event: motion for motion in motions if motion.event}
    for key, kind, stems, event in SPECIAL_KEYS:
        matching = [
            motion
            for motion in unbound.values()
            if motion.event == event or (motion.kind == kind and clip_names.has_stem(motion.clip, stems))
        ]
        if matching:
            best = min(
                matching, key=lambda motion: (motion.event != event, len(clip_names.words(motion.clip)))
            )
            del unbound[best.event]
            yield (
                key,
                f"{{hold: {best.event}, release: STOP}}"
                if best.kind == "loop"
                else f"{{press: {best.event}}}",
            )
    for key, event in zip(SHORT_KEYS, unbound, strict=False):
        yield key, f"{{press: {event}}}"
    yield "Escape", "{press: STOP}"


SPECIAL_KEYS: tuple[tuple[str, clip_names.Kind, str, str], ...] = (
    ("ArrowUp", "loop", "walk trot", "FORWARD"),
    ("Shift", "loop", "run jog sprint gallop", "RUN"),
    ("ArrowDown", "loop", "back crouch sneak", "CROUCH"),
    ("ArrowLeft", "loop", "left", "LEFT"),
    ("ArrowRight", "loop", "right", "RIGHT"),
    ("Space", "once", "jump", "JUMP"),
)
"""key, the kind and the stems of the clips that suit the key, and the event that suits it best"""
