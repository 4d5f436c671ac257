"""Two jumping boxes side by side, for the principles of animation (FAQ Q1): the grey one shows each motion as
it was keyed, the orange one the same motion with a principle. Each has an antenna and two arms.
"""

from collections.abc import Callable

import numpy as np
from model import Model, material, turn_about
from shapes import Array, Mesh, ball, box, joined, lathe, pipe

GREY, ORANGE = material("grey", "#8f959c", 0.7), material("orange", "#e8862e", 0.55)
DARK, WHITE = material("dark", "#2b2f36", 0.6), material("white", "#f4f1ea", 0.4)
STAND, LIGHT = material("stand", "#5d636b", 0.9), material("light", "#f2c14b", 0.35)
FIGURES = {"Plain": (-0.7, GREY), "Shown": (0.7, ORANGE)}
"""where each stands, metres along X, and its colour"""
WIDE, HIGH, DEEP, SLAB = 0.4, 0.46, 0.32, 0.04
LINK, LINKS = 0.11, 3
"""length and number of the antenna's bones"""
AWAY = 0.32
"""metres that it slides to either side"""
HOP_S, FLIGHT = 1.0, (0.16, 0.84)
GRAVITY = 9.81
LAST_KEYS = 24
"""keys per second: the frames of film"""
Curves = dict[tuple[str, str], Callable[[Array], Array]]
"""by a part of the figure and its property"""


def make() -> Model:
    """Both figures; they look along +Z."""
    model = Model("principles")
    model.joint("Stage")
    for name, (place, colour) in FIGURES.items():
        _figure(model, name, place, colour)
    for name, seconds, curves in _motions():
        both = {(f"{who}.{part}", path): values for who in FIGURES for (part, path), values in curves.items()}
        model.motion(name, seconds, both, LAST_KEYS)
    return model


def _figure(model: Model, name: str, place: float, colour: dict[str, object]) -> None:
    model.joint(name, "Stage", (place, SLAB, 0.0))
    model.joint(f"{name}.body", name)
    above = f"{name}.body"
    for link in range(1, LINKS + 1):
        above = model.joint(f"{name}.antenna{link}", above, (0.0, HIGH if link == 1 else LINK, 0.0))
    model.joint(f"{name}.antenna.tip", above, (0.0, LINK, 0.0))
    for side, letter in ((1, "L"), (-1, "R")):
        model.joint(f"{name}.arm.{letter}", f"{name}.body", (side * WIDE / 2, 0.27, 0.03))
        model.joint(f"{name}.hand.{letter}", f"{name}.arm.{letter}", (side * 0.1, -0.16, 0.0))
    slab = lathe([(0, -SLAB), (0.56, -SLAB), (0.56, -SLAB), (0.58, -0.01), (0.57, 0), (0.57, 0), (0, 0)], 48)
    model.part(name, slab, STAND)
    model.part(f"{name}.body", box((WIDE, HIGH, DEEP), 0.07, 5).moved(0, HIGH / 2, 0), colour)
    _face(model, f"{name}.body")
    rod = lathe([(0.014, 0), (0.011, LINK)], 10)
    for link in range(1, LINKS + 1):
        model.part(f"{name}.antenna{link}", joined(rod, ball(0.016, 10)), DARK)
    model.part(f"{name}.antenna.tip", ball(0.045, 16), LIGHT)
    for side, letter in ((1, "L"), (-1, "R")):
        model.part(f"{name}.arm.{letter}", _arm(side), DARK)
        model.part(f"{name}.hand.{letter}", ball(0.038, 14), colour)


def _arm(side: int) -> Mesh:
    spine = [(side * 0.1 * part, -0.16 * part, 0.0) for part in (-0.1, 0.0, 0.5, 1.0)]
    return joined(
        pipe(spine, (0, 0, 1), [0, 0.02, 0.016, 0.016], [0, 0.02, 0.016, 0.016], 10), ball(0.024, 10)
    )


def _face(model: Model, joint: str) -> None:
    for side in (-1, 1):
        at = (side * 0.075, 0.3, DEEP / 2 - 0.012)
        model.part(joint, ball(0.05, 18).moved(*at), WHITE)
        model.part(joint, ball(0.024, 12).moved(at[0], at[1], at[2] + 0.034), DARK)
    smile = [(0.07 * x, 0.19 + 0.03 * x * x, DEEP / 2 + 0.002) for x in np.linspace(-1, 1, 9)]
    model.part(joint, pipe(smile, (0, 0, 1), [0.008] * 9, [0.008] * 9, 8), DARK)


def _motions() -> list[tuple[str, float, Curves]]:
    """The motions as they are keyed: stiff on purpose, each without the principle that it is to show."""
    body, turn = ("body", "translation"), ("body", "rotation")
    return [
        ("stand", 4.0, {turn: lambda t: turn_about((0, 0, 1), np.sin(np.pi * t / 2))}),
        ("hop", HOP_S, {body: _hop}),
        ("slide", 1.2, {body: lambda t: _along(AWAY * _line(t, (0, 1.2), (-1, 1)))}),
        ("slide-back", 1.2, {body: lambda t: _along(AWAY * _line(t, (0, 1.2), (1, -1)))}),
        ("dash", 1.2, {body: lambda t: _along(AWAY * _line(t, (0, 0.25), (-1, 1)))}),
        ("dash-back", 1.2, {body: lambda t: _along(AWAY * _line(t, (0, 0.25), (1, -1)))}),
        ("nod", 1.6, {turn: lambda t: turn_about((0, 0, 1), 7 * np.sin(2 * np.pi * t / 1.6))}),
        ("zigzag", 2.4, {body: _zigzag}),
        ("wag", 0.5, _wag()),
        ("greet", 2.0, _greeting()),
        ("clap", 1.0, _clap(0.0)),
        ("clap-apart", 1.0, _clap(3 / LAST_KEYS)),
        *((f"pose-{number}", 0.8, _still(number)) for number in (1, 2, 3)),
    ]


def _line(t: Array, times: tuple[float, ...], values: tuple[float, ...]) -> Array:
    return np.asarray(np.interp(t, times, values))


def _along(x: Array, y: Array | float = 0.0) -> Array:
    """Places (K, 3)."""
    return np.stack([x, np.broadcast_to(y, x.shape), np.zeros_like(x)], -1)


def _hop(t: Array) -> Array:
    """Straight up and down, as a stone flies."""
    start, end = FLIGHT
    flown = np.clip(t - start, 0, end - start)
    return _along(np.zeros_like(t), GRAVITY / 2 * flown * (end - start - flown))


def _zigzag(t: Array) -> Array:
    """Straight from corner to corner of a diamond."""
    times = (0.0, 0.6, 1.2, 1.8, 2.4)
    return _along(_line(t, times, (-0.3, 0, 0.3, 0, -0.3)), _line(t, times, (0.2, 0.45, 0.2, 0.0, 0.2)))


def _arms(left: Callable[[Array], Array], right: Callable[[Array], Array]) -> Curves:
    """Arms raised by degrees."""
    return {
        ("arm.L", "rotation"): lambda t: turn_about((0, 0, 1), left(t)),
        ("arm.R", "rotation"): lambda t: turn_about((0, 0, 1), -right(t)),
    }


def _wag() -> Curves:
    """Antenna and arms to and fro, to lie above another motion."""
    return _arms(lambda t: 40 * _beat(t), lambda t: -40 * _beat(t)) | {
        ("antenna1", "rotation"): lambda t: turn_about((0, 0, 1), 22 * _beat(t))
    }


def _beat(t: Array) -> Array:
    return np.asarray(np.sin(4 * np.pi * t))


def _greeting() -> Curves:
    """It turns to its left and raises its left arm."""
    return _arms(lambda t: _gone(t) * (115 + 22 * _beat(t)), np.zeros_like) | {
        ("body", "rotation"): lambda t: turn_about((0, 1, 0), 38 * _gone(t))
    }


def _gone(t: Array) -> Array:
    return np.asarray(np.sin(np.pi * t / 2) ** 2)


def _clap(late: float) -> Curves:
    """Both arms, the right one `late` seconds after the left; at the same moment they are twins."""
    return _arms(lambda t: _lifted(t), lambda t: _lifted(t - late))


def _lifted(t: Array) -> Array:
    return np.asarray(75 * np.sin(np.pi * t) ** 2)


def _still(number: int) -> Curves:
    """One pose, held: up and to the left, low and to the right, upright with arms out."""
    lean, turn, left, right = ((10, 35, 130, 60), (-14, -30, -5, -5), (0, 0, 90, 90))[number - 1]
    tilted = turn_about((0, 0, 1), np.array([float(lean)]))[0]
    return _arms(lambda t: np.full_like(t, left), lambda t: np.full_like(t, right)) | {
        ("body", "rotation"): lambda t: _times(turn_about((0, 1, 0), np.full_like(t, turn)), tilted)
    }


def _times(first: Array, second: Array) -> Array:
    """Products (K, 4) of quaternions x y z w."""
    a, b = first[..., :3], np.broadcast_to(second[..., :3], first[..., :3].shape)
    v = first[..., 3:] * b + second[..., 3:] * a + np.cross(a, b)
    w = first[..., 3:] * second[..., 3:] - (a * b).sum(-1, keepdims=True)
    return np.concatenate([v, w], -1)
