"""A cannon that throws balls of paint: the ball flies twelve metres in four tenths of a second, and bursts
where it hits.
"""

from collections.abc import Callable

import numpy as np
from coin import scaled
from model import Model, Motion, material
from shapes import Array, about_x, about_z, ball, box, joined, lathe

WOOD = material("wood", "#7a4a22", 0.7)
IRON = material("iron", "#3d434c", 0.45, 0.2)
BRASS = material("brass", "#e0b84e", 0.3, 0.2)
PAINT = material("paint", "#e5383b", 0.25)
MUZZLE, FAR, HIGH, FLIGHT_S = 0.75, 12.0, 1.02, 0.4
DROPS = 10


def make() -> Model:
    """The cannon; `Ball` is what flies, `Shape` under it the ball that is seen, `Drop 1` … what it bursts
    into.
    """
    model = Model("cannon")
    model.joint("Ground")
    model.joint("Barrel", "Ground", (0.0, HIGH, 0.0))
    model.joint("Ball", "Ground", (0.0, HIGH, MUZZLE - 0.2))
    model.joint("Shape", "Ball")
    _body(model)
    model.part("Shape", ball(0.13, 20), PAINT)
    drops = [model.joint(f"Drop {number + 1}", "Ball") for number in range(DROPS)]
    for number, drop in enumerate(drops):
        model.part(drop, ball(0.035 + 0.012 * (number % 3), 10), PAINT)
    whole = {("Shape", "scale"): lambda t: scaled(0 * t + 1)} | {
        (drop, "scale"): lambda t: scaled(0 * t) for drop in drops
    }
    held = {("Ball", "translation"): lambda t: _path(0 * t)}
    still = {("Barrel", "translation"): lambda t: _along(0 * t)}
    model.motion("ready", 4.0, whole | held | still)
    model.motion(
        "load", 0.8, {**whole, **held, **still, ("Shape", "scale"): lambda t: scaled(np.clip(t / 0.6, 0, 1))}
    )
    recoil = {
        ("Barrel", "translation"): lambda t: _along(
            -0.25 * np.sin(np.pi * np.clip(t / FLIGHT_S, 0, 1)) * np.exp(-4 * t)
        )
    }
    model.motion(
        "throw", FLIGHT_S, {**whole, **recoil, ("Ball", "translation"): lambda t: _path(t / FLIGHT_S)}
    )
    model.motion(
        "miss",
        0.8,
        {
            **whole,
            **still,
            ("Ball", "translation"): _bounces,
            ("Shape", "scale"): lambda t: scaled(np.clip(3.5 - 5 * t, 0, 1)),
        },
    )
    model.motion("burst", 0.6, {("Shape", "scale"): lambda t: scaled(0 * t)} | _splash(drops))
    return model


def _along(z: Array) -> Array:
    return np.stack([0 * z, 0 * z + HIGH, z], -1)


def _path(part: Array) -> Array:
    """Nearly straight: a little up, then down."""
    return np.stack([0 * part, HIGH + 0.5 * part * (1 - part) - 0.12 * part, MUZZLE - 0.2 + FAR * part], -1)


def _bounces(t: Array) -> Array:
    """Down to the ground and up again, slower each time."""
    y = 0.13 + (HIGH - 0.25) * np.abs(np.cos(np.pi * t / 0.55)) * np.exp(-3 * t)
    return np.stack([0 * t, y, MUZZLE - 0.2 + FAR + 11 * t * np.exp(-0.7 * t)], -1)


def _splash(drops: list[str]) -> Motion:
    """Drops that fly off on all sides, fall, and dry up."""
    found: dict[tuple[str, str], Callable[[Array], Array]] = {}
    for number, drop in enumerate(drops):
        up, turn = 0.6 + 0.9 * ((number * 0.618) % 1), number * 2.39996
        way = np.array([1.6 * np.cos(turn), 1.2 * up, 1.6 * np.sin(turn) * 0.6 - 0.7])
        found[drop, "translation"] = lambda t, way=way: t[:, None] * way - np.outer(t * t, [0, 2.4, 0])
        found[drop, "scale"] = lambda t: scaled(np.clip(1.6 - t / 0.6 * 1.6, 0, 1))
    return found


def _body(model: Model) -> None:
    barrel = [
        (0.0, -0.5), (0.06, -0.5), (0.08, -0.45), (0.05, -0.4), (0.2, -0.36), (0.24, -0.3), (0.24, -0.2),
        (0.22, -0.18), (0.2, 0.55), (0.23, 0.58), (0.23, 0.68), (0.2, 0.7), (0.16, 0.7), (0.15, 0.2),
        (0.0, 0.2),
    ]  # fmt: skip
    model.part("Barrel", lathe(barrel, 28).turned(about_x(90)), IRON)
    band = lathe([(0.215, -0.03), (0.235, -0.02), (0.235, 0.02), (0.215, 0.03)], 28).turned(about_x(90))
    model.part("Barrel", joined(band.moved(0, 0, 0.1), band.moved(0, 0, 0.35)), BRASS)
    cheeks = [box((0.1, 0.5, 1.1), 0.03).moved(side * 0.3, HIGH - 0.3, -0.1) for side in (-1, 1)]
    model.part("Ground", joined(*cheeks, box((0.7, 0.12, 0.5), 0.03).moved(0, HIGH - 0.5, -0.2)), WOOD)
    hub = lathe([(0, -0.06), (0.08, -0.06), (0.08, 0.06), (0, 0.06)], 16).turned(about_z(90))
    rim = lathe([(0.38, -0.05), (0.45, -0.05), (0.45, 0.05), (0.38, 0.05), (0.38, -0.05)], 32).turned(
        about_z(90)
    )
    spokes = [box((0.05, 0.8, 0.05), 0.015).turned(about_x(angle)) for angle in (0, 45, 90, 135)]
    for side in (-1, 1):
        model.part("Ground", joined(rim, *spokes).moved(side * 0.46, 0.45, 0.05), WOOD)
        model.part("Ground", hub.moved(side * 0.46, 0.45, 0.05), BRASS)
