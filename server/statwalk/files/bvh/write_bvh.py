"""Writes a character's skeleton and its first clip as a BVH file.

BVH has no rotations at rest: every joint is written with the axes of the character, and turns from its rest
pose. Where the joints are is exact; how their own axes lay is lost.
"""

from __future__ import annotations

import re
from collections.abc import Container, Iterator, Sequence

import numpy as np

from statwalk.character.character import Character
from statwalk.files.bvh.hierarchy import LONGEST_NAME
from statwalk.files.bvh.write_frames import BvhMotion, motion_of
from statwalk.files.gltf.names import unique
from statwalk.files.held_parts import carriers
from statwalk.maths.arrays import Floats, Ints

DEEPEST_INDENT = 16
ROTATIONS = "Zrotation Yrotation Xrotation"
POSITIONS = "Xposition Yposition Zposition "
END = ".end"


def write_bvh(character: Character) -> bytes:
    """Returns a BVH file: the character's joints, and its first clip, or one frame of its rest pose.

    Lengths are the character's. Nodes that only carry a skinned mesh are left out; several roots hang on one
    root of their own. A joint that moves within its parent's axes has position channels.
    """
    motion = motion_of(character, next(iter(character.clips.values()), None))
    tree = _Tree(character, motion)
    lines = ["HIERARCHY", *tree.lines(), "MOTION", f"Frames: {len(motion.times)}"]
    lines.append(f"Frame Time: {motion.seconds:.9g}")
    head = "\n".join(lines) + "\n"
    return (head + _rows(tree.columns(), len(motion.times))).encode()


def _rows(columns: Sequence[Floats], frames: int) -> str:
    table = np.concatenate([*columns, np.zeros((frames, 0))], 1)
    table = np.where(np.abs(table) < 5e-10, 0.0, table)  # no -0
    return "".join(" ".join(f"{number:.9g}" for number in row) + "\n" for row in table.tolist())


class _Tree:
    """The joints in the order of the file: each before its children, brother after brother."""

    def __init__(self, character: Character, motion: BvhMotion) -> None:
        self.parent, self.motion = character.skeleton.parent, motion
        self.children = _children(self.parent, carriers(character))
        self.ends = self._ends(character.skeleton.names)
        self.names = one_word_names(character.skeleton.names, self.ends)
        self.added_root = unique([*self.names, _plain(character.name)], "root", between="_")[-1]
        self.is_joined = len(self.children[-1]) > 1

    def _ends(self, names: Sequence[str]) -> set[int]:
        """Returns the joints that BVH calls End Site: an only child PARENT.end, without children, at rest."""
        return {
            joint
            for joint, name in enumerate(names)
            if name.endswith(END)
            and (parent := int(self.parent[joint])) >= 0
            and name == names[parent] + END
            and not self.children[joint]
            and self.children[parent] == [joint]
            and not self.motion.moves[joint]
        }

    def lines(self) -> Iterator[str]:
        """Yields the lines of the hierarchy, without recursion: a skeleton may be deep."""
        open_joints = 1 if self.is_joined else 0
        if self.is_joined:
            yield from (f"ROOT {self.added_root}", "{", "\tOFFSET 0 0 0", f"\tCHANNELS 3 {ROTATIONS}")
        pending = [(joint, open_joints) for joint in reversed(self.children[-1])]
        while pending:
            joint, depth = pending.pop()
            if joint < 0:
                yield _indent(depth) + "}"
                continue
            yield from self._joint(joint, depth)
            pending.append((-1, depth))
            if not self.children[joint] and joint not in self.ends:
                pending.append((-1, depth + 1))
                yield from self._end_site(depth + 1, (0.0, 0.0, 0.0))
            pending += [(child, depth + 1) for child in reversed(self.children[joint])]
        if self.is_joined:
            yield "}"

    def _joint(self, joint: int, depth: int) -> Iterator[str]:
        offset = self.motion.offset[joint].tolist()
        if joint in self.ends:
            yield from self._end_site(depth, offset)
            return
        yield f"{_indent(depth)}{'JOINT' if depth else 'ROOT'} {self.names[joint]}"
        yield _indent(depth) + "{"
        yield f"{_indent(depth + 1)}OFFSET {_numbers(offset)}"
        moves = self._has_positions(joint)
        channels = POSITIONS + ROTATIONS if moves else ROTATIONS
        yield f"{_indent(depth + 1)}CHANNELS {6 if moves else 3} {channels}"

    def _end_site(self, depth: int, offset: Sequence[float]) -> Iterator[str]:
        yield _indent(depth) + "End Site"
        yield _indent(depth) + "{"
        yield f"{_indent(depth + 1)}OFFSET {_numbers(offset)}"

    def _has_positions(self, joint: int) -> bool:
        return bool(self.parent[joint] < 0) or bool(self.motion.moves[joint])

    def columns(self) -> list[Floats]:
        """Returns the numbers of the frames (F, n), joint by joint in the order of the hierarchy."""
        columns: list[Floats] = [np.zeros((len(self.motion.times), 3))] if self.is_joined else []
        pending = list(reversed(self.children[-1]))
        while pending:
            joint = pending.pop()
            pending += reversed(self.children[joint])
            if joint not in self.ends:
                if self._has_positions(joint):
                    columns.append(self.motion.position[:, joint])
                columns.append(self.motion.angles_deg[:, joint, ::-1])
        return columns


def _children(parent: Ints, left_out: Container[int]) -> dict[int, list[int]]:
    children: dict[int, list[int]] = {joint: [] for joint in range(-1, len(parent))}
    for joint, above in enumerate(parent.tolist()):
        if joint not in left_out:
            children[above].append(joint)
    return children


def one_word_names(names: Sequence[str], ends: Container[int] = ()) -> list[str]:
    """Returns names of one word each, which differ; only End Sites are called PARENT.end."""
    plain = [_plain(name) for name in names]
    return unique(
        [
            name if joint in ends or not name.endswith(END) else name.removesuffix(END) + "_end"
            for joint, name in enumerate(plain)
        ],
        "joint",
        between="_",
    )


def _plain(name: str) -> str:
    return re.sub(r"[\s{}\x00-\x1f]+", "_", name.strip())[: LONGEST_NAME - 10] or "joint"


def _indent(depth: int) -> str:
    return "\t" * min(depth, DEEPEST_INDENT)


def _numbers(values: Sequence[float]) -> str:
    return " ".join(f"{value:.9g}" for value in values)
