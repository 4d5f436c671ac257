"""Stick figures: lines from joint to joint where the pose says, from each side; a strip of pictures."""

import math
import xml.etree.ElementTree as ET
from dataclasses import replace

import numpy as np
import pytest
import tiny_model
from paths import MACHINES
from statwalk.errors import ContentError
from statwalk.files.character_yaml import load_character
from statwalk.files.drawn_bones import drawn_bones
from statwalk.files.film_strip import film_strip
from statwalk.files.gltf import read_model
from statwalk.files.skeleton_svg import INK, NEAR, PALE, SIDES

SVG = "{http://www.w3.org/2000/svg}"
MAMMAL = load_character(MACHINES / "faq-printed" / "character.yaml")
# by hand: what is to the right and upwards, if you look at a figure that faces +Z
SEEN = {"front": (0, 1), "back": (-0.0, 1), "left": (2, 1), "right": (2, 1), "top": (0, 2)}
SIGNS = {"front": (1, 1), "back": (-1, 1), "left": (-1, 1), "right": (1, 1), "top": (-1, 1)}


def pictures(text: str) -> list[ET.Element]:
    return ET.fromstring(text).findall(f"{SVG}g")


def circles(picture: ET.Element) -> np.ndarray:
    return np.array([(float(one.get("cx")), float(one.get("cy"))) for one in picture.iter(f"{SVG}circle")])


def bones(picture: ET.Element) -> list[tuple[float, ...]]:
    """The lines of a picture without its ground: (x1, y1, x2, y2)."""
    lines = (one for one in picture.iter(f"{SVG}line") if one.get("stroke") in (INK, PALE))
    return [tuple(float(line.get(key)) for key in ("x1", "y1", "x2", "y2")) for line in lines]


@pytest.mark.parametrize("side", SIDES)
def test_bones_lie_where_the_pose_says_seen_from_each_side(side: str) -> None:
    """The lengths and directions of all bones, against the world matrices: one scale for all."""
    (picture,) = pictures(film_strip(MAMMAL, "walk", [0.3], side=side))
    world = MAMMAL.world(MAMMAL.clip("walk").sample(0.3))[:, :3, 3]
    axes, signs = [int(abs(axis)) for axis in SEEN[side]], SIGNS[side]
    parents = MAMMAL.skeleton.parent
    expected = np.array(
        [(world[j] - world[parent])[axes] * signs for j, parent in enumerate(parents) if parent >= 0]
    )
    drawn = np.array([(x2 - x1, y1 - y2) for x1, y1, x2, y2 in bones(picture)])
    scale = np.abs(drawn).max() / np.abs(expected).max()
    for row in expected * scale:
        assert np.abs(drawn - row).sum(axis=1).min() < 0.5
    assert len(drawn) == len(expected)


def test_every_joint_has_a_circle_and_the_ground_is_at_zero() -> None:
    (picture,) = pictures(film_strip(MAMMAL))
    assert len(circles(picture)) == len(MAMMAL.skeleton)
    ground = next(line for line in picture.iter(f"{SVG}line"))
    lowest = MAMMAL.world(MAMMAL.bind_pose)[:, 1, 3].min()
    assert (float(ground.get("y1")) - circles(picture)[:, 1].max() > -0.2) == (lowest >= 0)


def test_a_strip_shows_the_clip_from_start_to_end() -> None:
    shown = pictures(film_strip(MAMMAL, "walk", frames=5))
    duration = MAMMAL.clip("walk").duration
    texts = [picture.findtext(f"{SVG}text") for picture in shown]
    assert texts == [f"walk {duration * k / 4:.2f} s" for k in range(5)]
    shapes = [circles(picture) - circles(picture).mean(axis=0) for picture in shown]
    assert np.abs(shapes[0] - shapes[2]).max() > 2


def test_what_is_behind_is_paler() -> None:
    """Seen from the right, what is on the left (+X) of the first joint is behind it."""
    world = MAMMAL.world(MAMMAL.bind_pose)[:, :3, 3]
    across = (world - world[0])[:, 0]
    for side, behind in (("left", -across), ("right", across)):
        (picture,) = pictures(film_strip(MAMMAL, side=side))
        pale = sum(one.get("fill") == PALE for one in picture.iter(f"{SVG}circle"))
        assert 0 < pale == (behind > NEAR * np.ptp(world)).sum()


def test_only_the_joints_of_skins_are_drawn() -> None:
    character = read_model(tiny_model.model(), "tiny")
    assert drawn_bones(character) == ([0, 1], [(0, 1)])


def test_bones_skip_what_is_not_drawn() -> None:
    root, binary = tiny_model.document()
    root["nodes"][0]["children"] = [3]
    root["nodes"].append({"name": "between", "children": [1]})
    character = read_model(tiny_model.glb(root, binary), "tiny")
    drawn = drawn_bones(character)
    assert [character.skeleton.names[joint] for joint in drawn.joints] == ["hip", "knee"]
    assert drawn.segments == [(0, 1)]


def test_names_are_text() -> None:
    strip = film_strip(replace(MAMMAL, name="<b>&\x07"))
    assert ET.fromstring(strip).findtext(f"{SVG}title") == "<b>&, seen from the right"


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"times": [0.1]}, "need a clip"),
        ({"clip": "walk", "times": [0.1], "frames": 2}, "not both"),
        ({"clip": "walk", "frames": 61}, "at most 60"),
        ({"clip": "walk", "times": [math.nan]}, "finite"),
        ({"side": "below"}, "no side is called 'below'"),
    ],
)
def test_what_cannot_be_drawn_is_refused(options: dict, words: str) -> None:
    with pytest.raises(ContentError, match=words):
        film_strip(MAMMAL, **options)
