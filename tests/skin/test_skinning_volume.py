"""What a cylinder keeps of its volume when its end is twisted by a half turn (docs/skinning.md)."""

import numpy as np
import pytest
from closed_volume import volume
from statwalk.skin.deform import surface
from statwalk.skin.primitive import Primitive, Skin
from statwalk.skin.skinning import reskinned

AROUND, RINGS = 64, 401
OVER = 0.5
"""the middle half goes over from one bone to the other, evenly"""
BIND = np.tile(np.eye(4, dtype=np.float32)[:3], (2, 1, 1))
TWISTED = np.array([np.eye(4)[:3], np.diag([-1.0, -1, 1, 1])[:3]], np.float32)


def cylinder():
    """Along Z from -0.5 to 0.5, of radius 0.1, closed at both ends."""
    angle, height = np.arange(AROUND) * 2 * np.pi / AROUND, np.linspace(-0.5, 0.5, RINGS)
    ring = 0.1 * np.stack([np.cos(angle), np.sin(angle)], 1)
    side = np.concatenate([np.tile(ring, (RINGS, 1)), np.repeat(height, AROUND)[:, None]], 1)
    points = np.concatenate([side, [[0, 0, -0.5], [0, 0, 0.5]]])
    row, column = np.meshgrid(np.arange(RINGS - 1) * AROUND, np.arange(AROUND), indexing="ij")
    a, b = (row + column).ravel(), (row + (column + 1) % AROUND).ravel()
    first, second = np.stack([a, b, b + AROUND], 1), np.stack([a, b + AROUND, a + AROUND], 1)
    around = np.arange(AROUND)
    last = (RINGS - 1) * AROUND + around
    low = np.stack([np.full(AROUND, len(side)), np.roll(around, -1), around], 1)
    high = np.stack([np.full(AROUND, len(side) + 1), last, np.roll(last, -1)], 1)
    faces = np.concatenate([first, second, low, high])
    share = np.clip(points[:, 2] / OVER + 0.5, 0, 1)
    weights = np.stack([1 - share, share], 1).astype(np.float32)
    joints = np.tile(np.array([0, 1], np.uint16), (len(points), 1))
    return Primitive(
        0,
        0,
        0,
        0,
        points.astype(np.float32),
        None,
        faces.reshape(-1).astype(np.uint32),
        4,
        None,
        0,
        joints,
        weights,
    )


def kept(skinning):
    """The volume of the twisted cylinder, as a part of the volume at rest."""
    (part,) = reskinned([cylinder()], skinning)
    shown = surface([part], [Skin("skin", np.arange(2, dtype=np.int32), BIND)], is_dual=skinning[0] == "d")
    at_rest, twisted = (
        volume(shown.posed_parts(world, np.zeros(0))[0].positions, part.indices) for world in (BIND, TWISTED)
    )
    assert at_rest == pytest.approx(np.pi * 0.01, rel=2e-3)
    return twisted / at_rest


def test_linear_skin_keeps_a_third_where_both_bones_hold_it():
    """At share w the radius is |1 - 2w| of what it was: the square's mean over w is 1/3."""
    assert kept("linear") == pytest.approx(1 - OVER * 2 / 3, abs=1e-4)


def test_dual_quaternions_keep_the_volume():
    assert kept("dual-quaternion") == pytest.approx(1, abs=1e-3)


@pytest.mark.parametrize("skinning", ["rigid", "parts"])
def test_bones_that_nothing_blends_keep_it_but_for_a_ring(skinning):
    assert kept(skinning) == pytest.approx(1, abs=1.5 / RINGS)


def main():
    """Prints the figures of docs/skinning.md."""
    for name in ("linear", "dual-quaternion", "rigid", "parts"):
        share = kept(name)
        print(f"{name}: {share:.2%}, where both bones hold it {1 - (1 - share) / OVER:.2%}")


if __name__ == "__main__":
    main()
