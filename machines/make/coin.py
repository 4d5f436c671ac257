"""A coin that turns over the ground, vanishes when it is taken, and comes back."""

import numpy as np
from model import Model, material, turn_about
from shapes import Array, about_x, box, joined, lathe

GOLD = material("gold", "#ffcf3f", 0.3, 0.15)
RIM = material("rim", "#d99a1c", 0.35, 0.15)
HEIGHT, TURN_S, VANISH_S, AWAY_S = 0.95, 2.0, 0.5, 10.0

EDGE = [
    (0.18, -0.02),
    (0.19, -0.028),
    (0.215, -0.028),
    (0.225, -0.018),
    (0.225, 0.018),
    (0.215, 0.028),
    (0.19, 0.028),
    (0.18, 0.02),
]
"""the rim's profile: radius and height, metres"""


def spun(degrees: Array) -> Array:
    """Turns about the upright axis."""
    return turn_about((0, 1, 0), degrees)


def scaled(size: Array) -> Array:
    """The same along all axes."""
    return np.repeat(np.asarray(size, float)[:, None], 3, 1)


def at(height: Array) -> Array:
    """So many metres over the ground."""
    height = np.asarray(height, float)
    return np.stack([0 * height, height, 0 * height], -1)


def make() -> Model:
    """The coin."""
    model = Model("coin")
    model.joint("Ground")
    model.joint("Coin", "Ground", (0.0, HEIGHT, 0.0))
    model.part("Coin", lathe(EDGE, 40).turned(about_x(90)), RIM)
    face = lathe(
        [(0.0, -0.02), (0.182, -0.02), (0.182, -0.02), (0.182, 0.02), (0.182, 0.02), (0.0, 0.02)], 40
    ).turned(about_x(90))
    mark = joined(
        *(
            box((0.05, 0.2, 0.06), 0.012),
            box((0.11, 0.035, 0.06), 0.012).moved(0, 0.09),
            box((0.11, 0.035, 0.06), 0.012).moved(0, -0.09),
        )
    )
    model.part("Coin", face, GOLD)
    model.part("Coin", mark, RIM)
    _motions(model)
    return model


def _motions(model: Model) -> None:
    """It turns, vanishes upwards, is away, and comes again."""
    model.motion(
        "spin",
        TURN_S,
        {
            ("Coin", "rotation"): lambda t: spun(360 * t / TURN_S),
            ("Coin", "translation"): lambda t: at(HEIGHT + 0.05 * np.sin(2 * np.pi * t / TURN_S)),
        },
    )
    model.motion(
        "vanish",
        VANISH_S,
        {
            ("Coin", "rotation"): lambda t: spun(900 * t / VANISH_S),
            ("Coin", "translation"): lambda t: at(HEIGHT + 0.7 * np.sqrt(t / VANISH_S)),
            ("Coin", "scale"): lambda t: scaled(
                np.clip(1.25 - 1.25 * (t / VANISH_S) ** 3, 0, 1) * (t < VANISH_S)
            ),
        },
    )
    model.motion(
        "away",
        AWAY_S,
        {("Coin", "scale"): lambda t: scaled(0 * t), ("Coin", "translation"): lambda t: at(0 * t + HEIGHT)},
    )
    model.motion(
        "appear",
        0.5,
        {
            ("Coin", "scale"): lambda t: scaled(np.sin(np.pi * np.clip(t / 0.5, 0, 1) / 2)),
            ("Coin", "rotation"): lambda t: spun(180 * (t / 0.5 - 1)),
        },
    )
