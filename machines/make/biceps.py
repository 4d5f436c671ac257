"""A dressmaker's dummy with two arms that bend together. Its left arm has a soft skin with muscle bones
(DS6); its right arm is a digital skin of vertex lists (DS7, `digital_arm`). What bulges is in `biceps.yaml`
(DS8).
"""

from collections.abc import Callable

import numpy as np
from arm_shape import FORE, UPPER, fist, rings, step, thumb
from model import Model, Motion, material, turn_about
from shapes import Array, Mesh, about_y, ball, grid_faces, joined, lathe, pipe, smooth

SKIN = material("skin", "#d79f80", 0.62)
CLOTH, HEM = material("cloth", "#34557a", 0.9), material("hem", "#e9e4d8", 0.85)
WOOD, IRON = material("wood", "#8a5a34", 0.5), material("iron", "#3a3d42", 0.4, 0.6)
SHOULDER = np.array([0.15, 0.56, 0.0])
"""metres: of the left arm"""
ELBOW = 0.038
"""metres on each side of the elbow in which the skin bends"""
BENT_DEG = 125.0
AROUND, RINGS = 28, 76
MUSCLES = {
    # place in the upper arm; half axes of the part of the skin that the muscle moves; its share in the middle
    "biceps": ((0.165, 0.024, 0.0), (0.115, 0.062, 0.068), 1.0),
    "triceps": ((0.14, -0.024, 0.0), (0.13, 0.062, 0.068), 1.0),
}
CURL_S, BEND_S = 2.4, 1.2


def make() -> Model:
    """The dummy, its arms stretched along X."""
    model = Model("biceps")
    model.joint("dummy")
    for side, sign in (("left", 1.0), ("right", -1.0)):
        x, y, z = SHOULDER
        model.joint(f"{side}_upperarm", "dummy", (sign * x, y, z))
        model.joint(f"{side}_forearm", f"{side}_upperarm", (sign * UPPER, 0.0, 0.0))
        model.joint(f"{side}_hand", f"{side}_forearm", (sign * FORE, 0.0, 0.0))
    for muscle, (place, _, _) in MUSCLES.items():
        model.joint(f"left_{muscle}", "left_upperarm", place)
    _arm(model)
    _dummy(model)
    model.motion("rest", 1.0, _bent(lambda times: 0 * times))
    model.motion("bend", BEND_S, _bent(lambda times: _ease(times / BEND_S)))
    model.motion("curl", CURL_S, _bent(lambda times: 0.5 - 0.5 * np.cos(2 * np.pi * times / CURL_S)))
    return model


def _ease(x: Array) -> Array:
    x = np.clip(x, 0, 1)
    return np.asarray(x * x * (3 - 2 * x))


def _bent(share: Callable[[Array], Array]) -> Motion:
    return {("left_forearm", "rotation"): lambda times: turn_about((0, 0, 1), BENT_DEG * share(times))}


def _arm(model: Model) -> None:
    """The left arm with its fist, in one skin."""
    wrist = np.array([UPPER + FORE, 0.0, 0.0])
    arm = rings(np.linspace(-0.02, wrist[0] - 0.005, RINGS), AROUND)
    places = np.concatenate([np.linspace(0.01, 0.09, 16), [0.095, 0.099, 0.101]])
    hand = fist(places, AROUND) + wrist
    end = np.broadcast_to(hand[-1:].mean(1, keepdims=True), hand[-1:].shape)
    finger = thumb(14, 16) + wrist
    tips = [np.broadcast_to(ring.mean(0), ring.shape)[None] for ring in (finger[0], finger[-1])]
    whole = np.concatenate([arm, hand, end]), np.concatenate([tips[0], finger, tips[1]])
    skin = joined(*(smooth(mesh.reshape(-1, 3), _outside(mesh)) for mesh in whole))
    x, y, z = SHOULDER.tolist()
    model.skinned(skin.moved(x, y, z), SKIN, shares(skin.points))


def _outside(tube: Array) -> Array:
    return grid_faces(len(tube), tube.shape[1])[:, ::-1]


def shares(points: Array) -> dict[str, Array]:
    """Weights (V,) of each joint of the left arm for points of the stretched arm."""
    x = points[:, 0]
    fore, hand = step(x, UPPER, ELBOW), step(x, UPPER + FORE, 0.02)
    muscles = {}
    for name, (place, size, most) in MUSCLES.items():
        out = (((points - np.array(place)) / np.array(size)) ** 2).sum(-1)
        side = step(points[:, 1] * np.sign(place[1]), 0.012, 0.022)
        muscles[name] = most * np.clip(1 - out, 0, 1) ** 0.7 * side * (1 - fore)
    taken = sum(muscles.values())
    return {
        "left_upperarm": np.clip(1 - fore - taken, 0, 1),
        "left_forearm": fore - hand,
        "left_hand": hand,
        **{f"left_{name}": weight for name, weight in muscles.items()},
    }


def _dummy(model: Model) -> None:
    """The torso in a shirt with short sleeves, its neck, and the stand."""
    table = [
        # height, half width, half depth: metres
        (0.2, 0.112, 0.085),
        (0.24, 0.12, 0.092),
        (0.32, 0.138, 0.104),
        (0.42, 0.16, 0.116),
        (0.49, 0.172, 0.118),
        (0.55, 0.165, 0.104),
        (0.6, 0.14, 0.088),
        (0.63, 0.1, 0.074),
        (0.65, 0.066, 0.062),
        (0.665, 0.056, 0.056),
    ]
    heights = np.array([row[0] for row in table])
    fine = np.concatenate([[heights[0] - 1e-3], np.linspace(heights[0], heights[-1], 40)])
    wide, deep = (np.interp(fine[1:], heights, [row[column] for row in table]) for column in (1, 2))
    wide, deep = (_soft(values) for values in (wide, deep))
    torso = pipe(
        [(0.0, float(y), 0.0) for y in fine],
        (1, 0, 0),
        [0.0, *wide.tolist()],
        [0.0, *deep.tolist()],
        40,
    )
    model.part("dummy", torso, CLOTH)
    sleeve = _sleeve()
    for mesh in (sleeve, sleeve.turned(about_y(180))):
        model.part("dummy", mesh, CLOTH)
    hem = _hem()
    for mesh in (hem, hem.turned(about_y(180))):
        model.part("dummy", mesh, HEM)
    model.part("dummy", lathe([(0.053, 0.65), (0.054, 0.69), (0.05, 0.705), (0.0, 0.715)], 32), WOOD)
    model.part("dummy", ball(0.026, 20).moved(y=0.733), WOOD)
    model.part("dummy", lathe([(0.014, 0.03), (0.014, 0.21)], 20), IRON)
    base = [(0.0, 0.0), (0.15, 0.0), (0.15, 0.0), (0.15, 0.014), (0.135, 0.022), (0.025, 0.032), (0.0, 0.05)]
    model.part("dummy", lathe(base, 48), IRON)


def _soft(values: Array) -> Array:
    """The values, smoothed along the torso."""
    padded = np.concatenate([values[:1].repeat(2), values, values[-1:].repeat(2)])
    return np.convolve(padded, [0.1, 0.2, 0.4, 0.2, 0.1], "valid")


def _sleeve() -> Mesh:
    """From the torso out over the left shoulder, open at its end."""
    x = np.array([0.0, 0.05, 0.09, 0.12, 0.15, 0.175, 0.2, 0.215, 0.225, 0.2255, 0.2165])
    tall = np.array([0.066, 0.081, 0.084, 0.082, 0.08, 0.077, 0.075, 0.0735, 0.073, 0.0685, 0.056])
    deep = np.array([0.066, 0.076, 0.078, 0.078, 0.076, 0.074, 0.072, 0.0705, 0.07, 0.0655, 0.056])
    y = np.interp(x, [0.02, 0.1, 0.17], [0.535, 0.552, 0.56])
    spine = [(float(a), float(b), 0.0) for a, b in zip(x, y, strict=True)]
    return pipe(spine, (0, 0, 1), deep.tolist(), tall.tolist(), 32)


def _hem() -> Mesh:
    """The edge of the left sleeve."""
    x = [0.212, 0.2125, 0.2295, 0.23, 0.2301]
    return pipe(
        [(a, SHOULDER[1], 0.0) for a in x],
        (0, 0, 1),
        [0.07, 0.072, 0.0715, 0.069, 0.056],
        [0.073, 0.075, 0.0745, 0.072, 0.056],
        32,
    )
