"""The FAQ's digital skin (Q20, Q21) as text: a list of vertices for each bone, one list of polygons for all.
DS7.

    #vertices Upper.arm #d9a184      vertices of a bone, x y z from the bone's start; their colour
    0 0.05 0
    0.2 0.06 0
    #vertices Lower.arm
    0 0.05 0
    #polygons                        vertices by their numbers, counted from 0 through the whole file
    0 1 2                            corners anticlockwise, seen from outside; three or more

Coordinates are along the axes of the bone at rest. A polygon whose corners belong to two bones is a glue
polygon. Lines that begin with `# ` are comments.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from statwalk.errors import TextError
from statwalk.files.faq.skeleton_text import lines_of, numbers, numbers_text
from statwalk.maths.arrays import Floats, Ints

MOST_VERTICES, MOST_CORNERS = 200_000, 64
VERTICES, POLYGONS = "#vertices", "#polygons"
PLAIN = "#d2b49a"
"""the colour of vertices without one"""
_COLOUR = re.compile(r"#[0-9a-fA-F]{6}")


class SkinText(NamedTuple):
    """A digital skin of V vertices, as the text has it."""

    bones: tuple[str, ...]
    """the names of the bones that have vertices"""
    bone: Ints
    """(V,) the place in `bones` of each vertex's bone"""
    positions: Floats
    """(V, 3) from the start of the vertex's bone"""
    colours: tuple[str, ...]
    """(V,) #rrggbb"""
    polygons: tuple[tuple[int, ...], ...]
    """the corners of each polygon"""
    places: tuple[str, ...] = ()
    """the line on which each bone in `bones` is named first"""


@dataclass
class _Reader:
    bones: dict[str, str] = field(default_factory=dict)
    """the line that names each bone first"""
    bone: list[int] = field(default_factory=list)
    positions: list[list[float]] = field(default_factory=list)
    colours: list[str] = field(default_factory=list)
    polygons: list[tuple[str, tuple[int, ...]]] = field(default_factory=list)
    block: str = ""
    at: int = 0
    colour: str = PLAIN

    def command(self, words: Sequence[str], place: str) -> None:
        """Begins a block of vertices or of polygons."""
        self.block = words[0]
        if words[0] == POLYGONS and len(words) == 1:
            return
        if words[0] != VERTICES or len(words) not in (2, 3):
            raise TextError(
                f"a block begins with {VERTICES} BONE, {VERTICES} BONE #rrggbb or {POLYGONS}, not with "
                f"{' '.join(words)[:80]!r}",
                place=place,
            )
        self.colour = words[2] if len(words) == 3 else PLAIN
        if not _COLOUR.fullmatch(self.colour):
            raise TextError(f"a colour is #rrggbb, not {self.colour[:40]!r}", place=place)
        self.bones.setdefault(words[1], place)
        self.at = list(self.bones).index(words[1])

    def row(self, words: Sequence[str], place: str) -> None:
        """Adds a vertex or a polygon."""
        if self.block == VERTICES:
            self._vertex(words, place)
        elif self.block == POLYGONS:
            self._polygon(words, place)
        else:
            raise TextError(f"a digital skin begins with {VERTICES} BONE", place=place)

    def _vertex(self, words: Sequence[str], place: str) -> None:
        if len(words) != 3:
            raise TextError(f"a vertex is x y z, not {' '.join(words)[:80]!r}", place=place)
        if len(self.positions) == MOST_VERTICES:
            raise TextError(f"a digital skin may have at most {MOST_VERTICES:,} vertices", place=place)
        self.positions.append(numbers(words, "a vertex", place))
        self.bone.append(self.at)
        self.colours.append(self.colour)

    def _polygon(self, words: Sequence[str], place: str) -> None:
        if not all(word.isascii() and word.isdigit() and len(word) < 10 for word in words):
            raise TextError(f"a polygon is numbers of vertices, not {' '.join(words)[:80]!r}", place=place)
        corners = tuple(map(int, words))
        if not 3 <= len(corners) <= MOST_CORNERS or len(set(corners)) < len(corners):
            raise TextError(
                f"a polygon has 3 to {MOST_CORNERS} corners, each once, not {' '.join(words)[:80]!r}",
                place=place,
            )
        self.polygons.append((place, corners))

    def skin(self) -> SkinText:
        """Returns what was read."""
        if not self.positions or not self.polygons:
            raise TextError("a digital skin needs vertices and polygons")
        for place, corners in self.polygons:
            if max(corners) >= len(self.positions):
                last = len(self.positions) - 1
                raise TextError(f"there is no vertex {max(corners)}; the last is {last}", place=place)
        return SkinText(
            tuple(self.bones),
            np.array(self.bone, np.int64),
            np.array(self.positions, np.float64),
            tuple(self.colours),
            tuple(corners for _, corners in self.polygons),
            tuple(self.bones.values()),
        )


def read_digital_skin(text: str) -> SkinText:
    """Reads a digital skin.

    :raises TextError: when a line is neither a block's beginning nor fits its block, a colour is none, a
        polygon has fewer than 3 corners or names a vertex that does not exist, or the skin is empty; `place`
        is the line.
    """
    reader = _Reader()
    for place, words in lines_of(text):
        if words[0].startswith("#"):
            reader.command(words, place)
        else:
            reader.row(words, place)
    return reader.skin()


def write_digital_skin(skin: SkinText) -> str:
    """Returns the text of a digital skin; `read_digital_skin` reads the same values from it, bit for bit."""
    lines: list[str] = []
    block: tuple[int, str] | None = None
    for bone, colour, position in zip(skin.bone.tolist(), skin.colours, skin.positions, strict=True):
        if block != (bone, colour):
            block = bone, colour
            lines.append(f"{VERTICES} {skin.bones[bone]}" + ("" if colour == PLAIN else f" {colour}"))
        lines.append(numbers_text(position))
    polygons = (" ".join(map(str, corners)) for corners in skin.polygons)
    return "\n".join([*lines, POLYGONS, *polygons]) + "\n"
