"""The right arm of the dummy as a digital skin (DS7): a list of vertices for each bone, and one list of
polygons. Quads between the last ring of a bone and the first of the next are glue polygons.
"""

from pathlib import Path

import numpy as np
from arm_shape import UPPER, fist, rings, thumb
from statwalk.files.faq.digital_skin_text import SkinText, write_digital_skin

AROUND = 16
COLOUR = "#d79f80"
BONES = ("right_upperarm", "right_forearm", "right_hand")
UPPER_RINGS = np.array([-0.02, 0.03, 0.06, 0.09, 0.12, 0.145, 0.17, 0.195, 0.22, 0.245, 0.265])
FORE_RINGS = UPPER + np.array([0.032, 0.055, 0.08, 0.11, 0.14, 0.175, 0.21, 0.24])
FIST_STEPS = np.array([1.0, 3.0, 5.2, 7.2, 9.0, 10.1]) / 100
THUMB_STEPS, AROUND_THUMB = 4, 8


def write(path: Path) -> None:
    """The text of the arm, stretched along -X."""
    upper = rings(UPPER_RINGS, AROUND)
    fore = rings(FORE_RINGS, AROUND) - [UPPER, 0, 0]
    lists = [upper, fore, fist(FIST_STEPS, AROUND)]
    polygons = _tube(sum(len(part) for part in lists), AROUND, 0)
    end = sum(len(part) for part in lists) * AROUND
    polygons.append(tuple(range(end - AROUND, end)))
    points = [part.reshape(-1, 3) for part in lists]
    polygons += [*_tube(THUMB_STEPS, AROUND_THUMB, end), tuple(end + np.arange(AROUND_THUMB)[::-1])]
    last = end + (THUMB_STEPS - 1) * AROUND_THUMB
    polygons.append(tuple(last + np.arange(AROUND_THUMB)))
    points[2] = np.concatenate([points[2], thumb(THUMB_STEPS, AROUND_THUMB).reshape(-1, 3)])
    bone = np.repeat(np.arange(3), [len(part) for part in points])
    places = np.concatenate(points).round(4) * [-1, 1, 1]
    whole = [tuple(int(corner) for corner in polygon) for polygon in polygons]
    skin = SkinText(BONES, bone, places, (COLOUR,) * len(places), tuple(whole))
    path.write_text(
        "# The dummy's right arm, made by machines/make/digital_arm.py.\n" + write_digital_skin(skin)
    )
    print(f"{path.parent.name}/{path.name}: {len(places)} vertices, {len(whole)} polygons")


def _tube(rows: int, around: int, first: int) -> list[tuple[int, ...]]:
    """Quads between rings; the arm is mirrored, so that the corners run the other way."""
    quads = []
    for row in range(rows - 1):
        for column in range(around):
            a, b = row * around + column, row * around + (column + 1) % around
            quads.append(tuple(first + corner for corner in (a, b, b + around, a + around)))
    return quads
