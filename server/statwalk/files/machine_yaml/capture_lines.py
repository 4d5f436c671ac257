"""The `captures` of a machine file: motion-capture files in its folder that become clips of its character.

captures:
  cmu: {file: walk.bvh, start: 1, end: 2.2, loop: true, filter: {low_pass: 6, spikes: true}}
  wave: {file: wave.trc, bones: {LeftHand: LWristJoint}, target_bones: {Hips: Body}}
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from statwalk.character.body_bones import BODY_BONES
from statwalk.character.capture import CaptureWish, with_capture
from statwalk.character.character import Character
from statwalk.character.retarget import Wish
from statwalk.errors import ContentError, MachineError, UnknownNameError
from statwalk.files.bvh.bvh_file import POSITIONS
from statwalk.files.captures import SUFFIXES, Reading, load_capture
from statwalk.files.clip_changes import read_filter
from statwalk.files.scale import LARGEST_SCALE, SMALLEST_SCALE
from statwalk.files.yaml.yaml_node import Node

MOST_CAPTURES = 64
LONGEST = 36_000.0
KEYS = ("file", "position", "scale", "start", "end", "loop", "filter", "bones", "target_bones")


@dataclass(frozen=True)
class CaptureLine:
    """A capture as the machine file names it; `file` and `place` say where, for errors."""

    path: str
    how: Reading
    wish: CaptureWish
    file: str
    place: str


def read_captures(node: Node | None) -> tuple[CaptureLine, ...]:
    """Reads `captures` of a machine file.

    :raises MachineError: when a key is unknown or its value is out of range.
    """
    if node is None or node.value == "":
        return ()
    entries = node.entries()
    if len(entries) > MOST_CAPTURES:
        raise node.refuse(f"there are {len(entries):,} captures here; at most {MOST_CAPTURES} are allowed")
    return tuple(_line(name, entry) for name, entry in entries.items())


def _line(name: str, node: Node) -> CaptureLine:
    entries = node.entries(*KEYS)
    if "file" not in entries:
        raise node.refuse("a capture needs a file: file: walk.bvh")
    position = entries["position"].text() if "position" in entries else "replace"
    if position not in POSITIONS:
        raise entries["position"].unknown("position", position, POSITIONS)
    scale = entries["scale"].number(SMALLEST_SCALE, LARGEST_SCALE) if "scale" in entries else 1.0
    start, end = (entries[key].number(0, LONGEST) if key in entries else None for key in ("start", "end"))
    carried = Wish(_bones(entries.get("bones")), _bones(entries.get("target_bones")), start or 0.0, end)
    wish = CaptureWish(
        name=name,
        carried=carried,
        filter=read_filter(entries.get("filter")),
        loop="loop" in entries and entries["loop"].truth(),
    )
    how = Reading("add" if position == "add" else "replace", scale)
    return CaptureLine(_path(entries["file"]), how, wish, node.file, f"line {node.line}")


def _path(node: Node) -> str:
    path = Path(node.text())
    if path.is_absolute() or ".." in path.parts or path.suffix.lower() not in SUFFIXES:
        raise node.refuse(f"{node.text()[:80]!r} must name a .bvh or .trc file in the folder of this file")
    return str(path)


def _bones(node: Node | None) -> dict[str, str] | None:
    """Reads which joint is which bone: `{LeftHand: hand_l}`; an empty joint means none."""
    if node is None:
        return None
    entries = node.entries()
    for bone in entries:
        if bone not in BODY_BONES:
            raise node.unknown("bone", bone, BODY_BONES, node.key_lines[bone])
    return {bone: joint.text() for bone, joint in entries.items()}


def with_captures(character: Character, lines: Sequence[CaptureLine], folder: Path) -> Character:
    """Returns the character with the captured motions as clips.

    :raises MachineError: when a capture is refused, or cannot be carried over; with the line that names it.
    """
    for line in lines:
        try:
            source = load_capture(folder / line.path, line.how)
            character, _, _ = with_capture(character, source, line.wish)
        except (ContentError, UnknownNameError) as error:
            reason = error.without_folder() if isinstance(error, ContentError) else error
            raise MachineError(
                f"capture {line.wish.name}: {reason}", file=line.file, place=line.place
            ) from None
    return character
