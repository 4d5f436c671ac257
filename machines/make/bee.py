"""A bee, as large as a sparrow, so that one sees it."""

from itertools import pairwise

import numpy as np
from model import Model, Motion, material, turn_about
from shapes import ball, joined, loft, mirrored, wing

YELLOW = material("yellow", "#f6b81a", 0.6)
BLACK = material("black", "#231c16", 0.6)
WING = material("wing", "#e8f1f6", 0.2, alphaMode="BLEND", doubleSided=True)
BUZZ_S = 0.15


def make() -> Model:
    """The bee; it flies along +Z."""
    model = Model("bee")
    model.joint("Body")
    model.joint("Tail", "Body", (0.0, 0.0, -0.02))
    for side, name in ((1, "Left"), (-1, "Right")):
        model.joint(f"{name}.wing", "Body", (side * 0.02, 0.035, 0.015))
    radius = lambda z: 0.045 * np.sqrt(np.clip(1 - ((z + 0.05) / 0.075) ** 2, 0, 1))  # noqa: E731
    edges = np.linspace(-0.125, 0.025, 8)
    bands = [np.linspace(first, last, 3) for first, last in pairwise(edges)]
    rings = [
        loft([(0, 0, float(at) + 0.01) for at in z], radius(z).tolist(), (0.92 * radius(z)).tolist(), 12)
        for z in bands
    ]
    model.part("Tail", joined(*rings[0::2]), BLACK)
    model.part("Tail", joined(*rings[1::2]), YELLOW)
    chest = np.linspace(-0.035, 0.045, 5)
    round_ = (0.036 * np.sqrt(np.clip(1 - ((chest - 0.005) / 0.04) ** 2, 0, 1))).tolist()
    model.part("Body", loft([(0, 0.005, float(at) + 0.02) for at in chest], round_, round_, 12), YELLOW)
    model.part("Body", ball(0.026, 10).moved(0, 0.0, 0.078), BLACK)
    model.part(
        "Body",
        joined(*(ball(0.013, 8).moved(side * 0.019, 0.006, 0.088) for side in (-1, 1))),
        material("eyes", "#5a1f14", 0.2),
    )
    leaf = wing(
        [0.0, 0.02, 0.05, 0.08, 0.1, 0.108],
        [0.004, 0.012, 0.02, 0.02, 0.012, 0.0],
        [-0.004, -0.014, -0.03, -0.034, -0.022, -0.006],
        [0.002] * 6,
    )
    model.part("Left.wing", leaf, WING)
    model.part("Right.wing", mirrored(leaf), WING)
    model.motion("buzz", BUZZ_S, _buzz())
    return model


def _buzz() -> Motion:
    motion = {("Tail", "rotation"): lambda t: turn_about((1, 0, 0), 6 + 3 * np.sin(2 * np.pi * t / BUZZ_S))}
    for side, name in ((1, "Left"), (-1, "Right")):
        motion[f"{name}.wing", "rotation"] = lambda t, side=side: turn_about(
            (0, 0, 1), side * (20 + 45 * np.sin(2 * np.pi * t / BUZZ_S))
        )
    return motion
