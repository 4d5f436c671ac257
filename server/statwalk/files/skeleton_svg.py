"""Draws skeletons as SVG: stick figures from one side, beside each other as a film strip (RD1, FAQ Q27).

A line goes from each joint to its parent, a circle marks each joint. What is further away than the first
joint is paler. The figures share one scale; each stands in the middle of its picture, on its own ground line.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Literal, NamedTuple, get_args
from xml.sax.saxutils import escape

import numpy as np

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.drawn_bones import drawn_bones
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose

HEIGHT, MARGIN, LETTERS = 240.0, 14.0, 16.0
"""pixels: of a picture, around the figure in it, and of the line of text below"""
WIDEST = 4.0
"""of a picture, relative to its height"""
MOST_JOINTS = 20_000
"""joints of all pictures together"""
NEAR = 0.03
"""a joint is near up to this share of the figure's size behind the first joint"""
PAPER, GROUND, INK, PALE, ACCENT = "#ffffff", "#c9ccd1", "#20252b", "#9aa1aa", "#d9480f"

Side = Literal["front", "back", "left", "right", "top"]
SIDES: tuple[Side, ...] = get_args(Side)
_AXES: Mapping[
    str, tuple[tuple[float, float, float], tuple[float, float, float], tuple[float, float, float]]
] = {
    "front": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "back": ((-1, 0, 0), (0, 1, 0), (0, 0, -1)),
    "left": ((0, 0, -1), (0, 1, 0), (1, 0, 0)),
    "right": ((0, 0, 1), (0, 1, 0), (-1, 0, 0)),
    "top": ((-1, 0, 0), (0, 0, 1), (0, 1, 0)),
}
"""by the side of the character that is seen: its directions to the right, upwards, and towards the viewer"""


class Picture(NamedTuple):
    """The figure of one pose, projected: places (J,2) to the right and upwards, metres; whether each joint is
    near; the text below.
    """

    places: Floats
    near: Sequence[bool]
    text: str


def skeleton_svg(character: Character, poses: Pose, texts: Sequence[str], side: Side = "right") -> str:
    """Returns the poses (N, J, …) as an SVG of N pictures side by side, each with its text below.

    :raises ContentError: when the pictures have more than MOST_JOINTS joints together.
    """
    bones = drawn_bones(character)
    if len(texts) * len(bones.joints) > MOST_JOINTS:
        raise ContentError(
            f"{len(texts)} pictures of {len(bones.joints)} joints are too many: ask for fewer pictures; "
            f"at most {MOST_JOINTS} joints are drawn"
        )
    world = character.world(poses)[:, bones.joints][..., :3, 3].astype(np.float64)
    pictures = [_picture(places, text, side) for places, text in zip(world, texts, strict=True)]
    return "\n".join(_document(character.name, side, pictures, bones.segments)) + "\n"


def _picture(places: Floats, text: str, side: Side) -> Picture:
    right, up, towards = (np.array(axis, np.float64) for axis in _AXES[side])
    depth = (places - places[0]) @ towards
    flat = np.stack([(places - places[0]) @ right, (places - (places[0] if side == "top" else 0)) @ up], -1)
    return Picture(flat, (depth > -NEAR * np.ptp(places)).tolist(), text)


def _document(
    name: str, side: Side, pictures: Sequence[Picture], segments: Sequence[tuple[int, int]]
) -> Iterator[str]:
    every = np.concatenate([picture.places for picture in pictures])
    low, high = every.min(0), every.max(0)
    if side != "top":
        low[1] = min(low[1], 0.0)
    scale = min((HEIGHT - 2 * MARGIN) / max(high[1] - low[1], 1e-6), _wide() / max(high[0] - low[0], 1e-6))
    width = (high[0] - low[0]) * scale + 2 * MARGIN
    total, tall = width * len(pictures), HEIGHT + LETTERS
    yield (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {total:.1f} {tall:.1f}" width="{total:.0f}" '
        f'height="{tall:.0f}" font-family="system-ui, sans-serif" font-size="11" text-anchor="middle">'
    )
    yield f"<title>{escape(_plain(name))}, seen from {'above' if side == 'top' else f'the {side}'}</title>"
    yield f'<rect width="{total:.1f}" height="{tall:.1f}" fill="{PAPER}"/>'
    for k, picture in enumerate(pictures):
        at = np.array([k * width + MARGIN - low[0] * scale, HEIGHT - MARGIN + low[1] * scale])
        yield f'<g id="picture-{k}">'
        if side != "top":
            ends = f'x1="{k * width + 4:.1f}" x2="{(k + 1) * width - 4:.1f}"'
            yield f'<line {ends} y1="{at[1]:.1f}" y2="{at[1]:.1f}" stroke="{GROUND}"/>'
        yield from _figure(at + picture.places * (scale, -scale), picture.near, segments)
        place = f'x="{(k + 0.5) * width:.1f}" y="{HEIGHT + 8:.1f}"'
        yield f'<text {place} fill="{INK}">{escape(_plain(picture.text))}</text>'
        yield "</g>"
    yield "</svg>"


def _wide() -> float:
    return WIDEST * HEIGHT - 2 * MARGIN


def _figure(places: Floats, near: Sequence[bool], segments: Sequence[tuple[int, int]]) -> Iterator[str]:
    """Yields the bones and joints, what is far first."""
    for is_near in (False, True):
        colour = INK if is_near else PALE
        for start, end in segments:
            if near[end] == is_near:
                (x1, y1), (x2, y2) = places[start], places[end]
                yield (
                    f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{colour}" '
                    'stroke-width="2.5" stroke-linecap="round"/>'
                )
        for (x, y), joint_near in zip(places.tolist(), near, strict=True):
            if joint_near == is_near:
                fill = ACCENT if is_near else PALE
                yield f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.6" fill="{fill}" stroke="{PAPER}"/>'


def _plain(text: str) -> str:
    """Returns the text without characters that XML cannot hold."""
    return "".join(letter for letter in text if letter.isprintable())
