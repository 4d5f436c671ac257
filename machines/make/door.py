"""A door in a wall, with a trip-wire on either side."""

import numpy as np
from model import Model, material, turn_about
from shapes import Array, about_z, ball, box, joined, lathe

PLASTER = material("plaster", "#d9c7a8", 0.9)
BRICK = material("brick", "#a5604a", 0.85)
OAK = material("oak", "#8a5a2b", 0.55)
DARK_OAK = material("dark oak", "#5d3a1a", 0.6)
BRASS = material("brass", "#e0b84e", 0.3, 0.2)
IRON = material("iron", "#4a4f57", 0.45, 0.2)
BEAM = material("beam", "#ff2a1a", 0.4, emissiveFactor=[1.0, 0.1, 0.05])
WIDE, TALL, WIRE = 0.96, 2.06, 1.1


def eased(part: Array) -> Array:
    """From 0 to 1 without a jerk."""
    f = np.clip(part, 0, 1)
    return f * f * f * (f * (f * 6 - 15) + 10)


def make() -> Model:
    """The door: `Leaf` hangs on its left edge."""
    model = Model("door")
    model.joint("Door")
    model.joint("Leaf", "Door", (-WIDE / 2, 0.02, 0.0))
    for side in (-1, 1):
        model.part(
            "Door",
            box((0.12, TALL + 0.16, 0.2), 0.012).moved(side * (WIDE / 2 + 0.06), TALL / 2 + 0.08),
            DARK_OAK,
        )
        model.part("Door", box((1.5, 2.3, 0.14), 0.02).moved(side * (WIDE / 2 + 0.87), 1.3), PLASTER)
        model.part("Door", box((1.5, 0.3, 0.18), 0.02).moved(side * (WIDE / 2 + 0.87), 0.15), BRICK)
    model.part("Door", box((WIDE + 0.3, 0.28, 0.14), 0.02).moved(0, TALL + 0.25), PLASTER)
    model.part("Door", box((WIDE + 3.3, 0.08, 0.22), 0.02).moved(0, 2.48), BRICK)
    model.part("Door", box((WIDE + 0.3, 0.14, 0.22), 0.012).moved(0, TALL + 0.11), DARK_OAK)
    model.part("Door", box((WIDE + 0.24, 0.02, 0.34), 0.008).moved(0, 0.01), IRON)
    _leaf(model)
    _wires(model)
    model.motion("shut", 1.0, {("Leaf", "rotation"): lambda t: turn_about((0, 1, 0), 0 * t)})
    model.motion("open", 0.8, {("Leaf", "rotation"): lambda t: turn_about((0, 1, 0), -100 * eased(t / 0.8))})
    model.motion("opened", 1.0, {("Leaf", "rotation"): lambda t: turn_about((0, 1, 0), 0 * t - 100)})
    model.motion(
        "close", 1.1, {("Leaf", "rotation"): lambda t: turn_about((0, 1, 0), -100 * (1 - eased(t / 1.1)))}
    )
    return model


def _leaf(model: Model) -> None:
    model.part("Leaf", box((WIDE - 0.02, TALL - 0.04, 0.045), 0.008).moved(WIDE / 2, TALL / 2), OAK)
    panels = [
        box((0.32, height, 0.075), 0.02).moved(WIDE / 2 + x, middle)
        for x in (-0.2, 0.2)
        for middle, height in ((0.48, 0.62), (1.36, 0.92))
    ]
    model.part("Leaf", joined(*panels), DARK_OAK)
    knobs = [ball(0.04).moved(WIDE - 0.1, 1.0, side * 0.075) for side in (-1, 1)]
    model.part("Leaf", joined(*knobs, box((0.05, 0.16, 0.065), 0.01).moved(WIDE - 0.1, 1.0)), BRASS)
    hinges = [
        lathe([(0, -0.06), (0.018, -0.06), (0.018, 0.06), (0, 0.06)], 12).moved(0, height, 0.02)
        for height in (0.3, 1.75)
    ]
    model.part("Leaf", joined(*hinges), IRON)


def _wires(model: Model) -> None:
    post = lathe(
        [(0.05, 0), (0.05, 0.02), (0.025, 0.03), (0.02, 0.3), (0.03, 0.31), (0.03, 0.35), (0, 0.36)], 14
    )
    beam = lathe([(0, -0.85), (0.008, -0.85), (0.008, 0.85), (0, 0.85)], 8).turned(about_z(90))
    for side in (-1, 1):
        model.part("Door", joined(*(post.moved(x, 0, side * WIRE) for x in (-0.85, 0.85))), IRON)
        model.part("Door", beam.moved(0, 0.33, side * WIRE), BEAM)
