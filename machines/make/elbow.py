"""An arm of two bones in one striped skin, to compare the ways of skinning (RTCA 2.1 to 2.3).

The skin goes over from one bone to the other along 0.32 m around the elbow.
"""

import numpy as np
from model import Model, Motion, linear, material, turn_about
from shapes import Array, Mesh, about_z, lathe

SKIN = material("striped", "#ffffff", 0.55)
LIGHT, DARK = (np.array(linear(colour)) for colour in ("#f2d7b6", "#c9744f"))
LENGTH, RADIUS, HEIGHT = 0.55, 0.085, 0.9
"""metres: of each bone, around, and above the ground"""
OVER = 0.32
"""metres along which both bones hold the skin"""
AROUND, RINGS, ROUND = 36, 72, 8
"""points around; rings along the arm, and of each round end"""
BENT_DEG, TWISTED_DEG = 120.0, 179.0
"""a half turn has no direction: the twist stops a degree before it"""
SECONDS = 1.5


def make() -> Model:
    """The arm, stretched along +X."""
    model = Model("elbow")
    model.joint("upper", at=(-LENGTH, HEIGHT, 0.0))
    model.joint("fore", "upper", (LENGTH, 0.0, 0.0))
    model.joint("hand", "fore", (LENGTH, 0.0, 0.0))
    tube = _tube()
    fore = _step(tube.points[:, 0] / OVER + 0.5)
    shares = {"upper": 1 - fore, "fore": fore, "hand": 0 * fore}
    model.skinned(tube.moved(y=HEIGHT), SKIN, shares, _stripes(tube))
    model.motion("rest", 1.0, _turn((0, 0, 1), 0.0))
    model.motion("bend", SECONDS, _turn((0, 0, 1), BENT_DEG))
    model.motion("twist", SECONDS, _turn((1, 0, 0), TWISTED_DEG))
    return model


def _tube() -> Mesh:
    """A tube along X with round ends."""
    turn = np.linspace(-np.pi / 2, 0, ROUND)[:-1]
    low, wide = RADIUS * np.sin(turn) - LENGTH, RADIUS * np.cos(turn)
    along = np.linspace(-LENGTH, LENGTH, RINGS)
    high = np.concatenate([low, along, -low[::-1]])
    radius = np.concatenate([wide, np.full(RINGS, RADIUS), wide[::-1]])
    radius[[0, -1]] = 0
    profile = list(zip(radius.tolist(), high.tolist(), strict=True))
    return lathe(profile, AROUND).turned(about_z(-90))


def _stripes(tube: Mesh) -> Array:
    """Colours (V, 3): five stripes along the arm."""
    angle = np.arctan2(tube.points[:, 2], tube.points[:, 1])
    share = _step(0.5 + 2.5 * np.sin(5 * angle))[:, None]
    return np.asarray(share * LIGHT + (1 - share) * DARK)


def _step(x: Array) -> Array:
    x = np.clip(x, 0, 1)
    return np.asarray(x * x * (3 - 2 * x))


def _turn(axis: tuple[float, float, float], degrees: float) -> Motion:
    """The forearm turns about an axis, slowly at the start and at the end."""
    return {("fore", "rotation"): lambda times: turn_about(axis, degrees * _step(times / SECONDS))}
