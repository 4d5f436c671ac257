"""The front of a car, whose headlights are eyes and whose grille is a mouth (FAQ Q35);
`machines/car-face/car.yaml` gives it muscles.
"""

import numpy as np
from model import Model, Motion, material, turn_about
from shapes import Array, Mesh, ball, box, joined, pipe, smooth

PAINT, DARK = material("paint", "#d8432f", 0.35, 0.1), material("dark", "#20242b", 0.6)
CHROME, GLASS = material("chrome", "#c9ced6", 0.25, 0.6), material("glass", "#f6f7f4", 0.15)
IRIS, TYRE = material("iris", "#2f6f9f", 0.2), material("tyre", "#2a2c30", 0.9)
WINDOW = material("window", "#7fa3b8", 0.15)
EYE_X, EYE_Y, EYE_RADIUS = 0.56, 0.86, 0.185
SECONDS = 6.0
BLINKS = (1.3, 4.2)


def make() -> Model:
    """The front; it looks along +Z."""
    model = Model("car")
    model.joint("Car")
    model.joint("Body", "Car")
    model.joint("Bumper", "Body")
    for side, sign in (("Left", 1.0), ("Right", -1.0)):
        at = (sign * EYE_X, EYE_Y, _front(np.array([EYE_X]), np.array([EYE_Y]))[0] - 0.085)
        model.joint(f"{side}.eye", "Body", at)
        model.joint(f"{side}.lid", "Body", at)
        model.part(f"{side}.eye", ball(EYE_RADIUS, 40), GLASS)
        model.part(f"{side}.eye", _cap(EYE_RADIUS * 1.008, 30.0), IRIS)
        model.part(f"{side}.eye", _cap(EYE_RADIUS * 1.016, 15.0), DARK)
        model.part(f"{side}.lid", _lid(EYE_RADIUS * 1.07), PAINT)
        model.part("Car", _wheel().moved(sign * 0.80, 0.30, -0.35), TYRE)
    for surface, stuff in (
        (_body(), PAINT),
        (_strip(0.235, 0.000, -0.012), DARK),
        (joined(_lip(0.075), _lip(-0.075), _slats()), CHROME),
        (_brows(), DARK),
        (_windscreen(), WINDOW),
    ):
        model.skinned(surface, stuff, {"Body": np.ones(len(surface.points))})
    bumper = _bumper()
    model.skinned(bumper, CHROME, {"Bumper": np.ones(len(bumper.points))})
    model.motion("idle", SECONDS, _idle(), 30)
    return model


def _front(x: Array, y: Array) -> Array:
    """Where the front is (Z), round at its sides and above."""
    return np.asarray(
        0.72 - 0.30 * (x / 0.95) ** 4 - 0.16 * (np.maximum(y - 0.75, 0) / 0.4) ** 2 - 0.05 * (x / 0.95) ** 2
    )


def _body() -> Mesh:
    """The bonnet, the wings and the front in one net, from the windscreen down to the sill."""
    across = np.linspace(-1, 1, 81)
    rows = [
        # height in the middle, fall to the sides, how far in front (of the front), half width
        (1.16, 0.10, -1.10, 0.86),
        (1.15, 0.10, -0.80, 0.90),
        (1.13, 0.10, -0.50, 0.93),
        (1.10, 0.10, -0.25, 0.95),
        (1.06, 0.09, -0.08, 0.95),
    ]
    table = np.array(rows)
    fine = np.linspace(0, len(rows) - 1, 25)
    high, fall, back, half = (np.interp(fine, np.arange(len(rows)), column) for column in table.T)
    bonnet = []
    for h, f, b, w in zip(high, fall, back, half, strict=True):
        x = w * np.sin(across * np.pi / 2)
        y = h - f * np.abs(across) ** 3
        bonnet.append(np.stack([x, y, _front(x, np.full(81, 1.06)) + b - 0.02], -1))
    for y in np.linspace(1.02, 0.24, 46):
        x = 0.95 * np.sin(across * np.pi / 2)
        level = y - 0.09 * np.abs(across) ** 3 * (y - 0.24) / 0.8
        bonnet.append(np.stack([x, level, _front(x, level)], -1))
    return _net(np.array(bonnet))


def _net(points: Array) -> Mesh:
    """A net (R, C, 3) seen from +Z, its rows from above."""
    rows, columns = points.shape[:2]
    row, column = np.meshgrid(np.arange(rows - 1), np.arange(columns - 1), indexing="ij")
    a = (row * columns + column).reshape(-1)
    b, c, d = a + 1, a + columns, a + columns + 1
    faces = np.concatenate([np.stack([a, c, b], -1), np.stack([b, c, d], -1)])
    return smooth(points.reshape(-1, 3), faces)


def _mouth(f: Array) -> Array:
    """The middle line of the grille (K, 2), f from -1 to 1."""
    return np.stack([0.52 * f, 0.505 + 0.012 * f * f], -1)


def _strip(height: float, up: float, front: float) -> Mesh:
    """The dark grille: a band along the mouth, pointed at its ends."""
    f = np.linspace(-1, 1, 61)
    flat = _mouth(f)
    half = 0.5 * height * (1 - np.abs(f) ** 3.5) ** 0.6 * 0.66
    levels = np.linspace(1, -1, 13)
    points = np.array(
        [
            np.stack(
                [
                    flat[:, 0],
                    y := flat[:, 1] + up + level * half,
                    _front(flat[:, 0], y) + 0.012 + front + 0.008,
                ],
                -1,
            )
            for level in levels
        ]
    )
    return _net(points)


def _lip(at: float) -> Mesh:
    """A chrome bar over or under the grille."""
    f = np.linspace(-1, 1, 61)
    flat = _mouth(f)
    y = flat[:, 1] + at * (1 - np.abs(f) ** 3.5) ** 0.6
    spine = [tuple(p) for p in np.stack([flat[:, 0], y, _front(flat[:, 0], y) + 0.012], -1).tolist()]
    thick = 0.020 * np.maximum(1 - np.abs(f) ** 8, 0) + 0.006
    thick[[0, -1]] = 0
    return pipe(spine, (0, 1, 0), thick.tolist(), thick.tolist(), 12)


def _slats() -> Mesh:
    """Upright chrome bars in the grille: the teeth."""
    bars = []
    for f in np.linspace(-0.78, 0.78, 13):
        x, y = _mouth(np.array([f]))[0]
        half = 0.070 * (1 - abs(f) ** 3.5) ** 0.6
        levels = np.linspace(-1, 1, 9)
        spine = [
            (float(x), float(y + half * s), float(_front(np.array([x]), np.array([y]))[0] + 0.012))
            for s in levels
        ]
        thick = [0.0, *[0.011] * 7, 0.0]
        bars.append(pipe(spine, (1, 0, 0), thick, thick, 8))
    return joined(*bars)


def _bumper() -> Mesh:
    """A chrome bumper: the chin."""
    f = np.linspace(-1, 1, 61)
    x = 0.93 * np.sin(f * np.pi / 2)
    y = np.full(61, 0.27)
    spine = [tuple(p) for p in np.stack([x, y, _front(x, y) + 0.02], -1).tolist()]
    size = np.sqrt(np.maximum(1 - np.abs(f) ** 12, 0))
    return pipe(spine, (0, 1, 0), (0.055 * size).tolist(), (0.04 * size).tolist(), 14)


def _brows() -> Mesh:
    """Two dark ridges over the headlights."""
    ridges = []
    for sign in (1.0, -1.0):
        f = np.linspace(-1, 1, 25)
        x = EYE_X + 0.21 * f
        y = EYE_Y + 0.235 - 0.03 * f * f
        z = _front(x, np.full(25, EYE_Y + 0.10)) + 0.075
        size = 0.024 * np.sqrt(np.maximum(1 - f**6, 0))
        spine = [(float(sign * a), float(b), float(c)) for a, b, c in zip(x, y, z, strict=True)]
        if sign < 0:
            spine, size = spine[::-1], size[::-1]
        ridges.append(pipe(spine, (0, 1, 0), size.tolist(), size.tolist(), 12))
    return joined(*ridges)


def _windscreen() -> Mesh:
    """A pane behind the bonnet, and the roof's edge."""
    pane = box((1.45, 0.5, 0.05), 0.02).turned(_tilt(-32)).moved(0, 1.36, -0.62)
    return joined(pane, box((1.38, 0.07, 0.5), 0.03).moved(0, 1.60, -1.0))


def _tilt(degrees: float) -> Array:
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])


def _cap(radius: float, degrees: float) -> Mesh:
    """The part of a ball around +Z within an angle."""
    turn, angle = 2 * np.pi * np.arange(32) / 32, np.radians(np.linspace(0, degrees, 7))
    points = radius * np.stack(
        [
            np.outer(np.sin(angle), np.cos(turn)),
            np.outer(np.sin(angle), np.sin(turn)),
            np.outer(np.cos(angle), np.ones(32)),
        ],
        -1,
    )
    row, column = np.meshgrid(np.arange(6), np.arange(32), indexing="ij")
    a, b = row * 32 + column, row * 32 + (column + 1) % 32
    faces = np.concatenate(
        [np.stack([a, a + 32, b], -1).reshape(-1, 3), np.stack([b, a + 32, b + 32], -1).reshape(-1, 3)]
    )
    return smooth(points.reshape(-1, 3), faces)


def _lid(radius: float) -> Mesh:
    """A quarter of a ball over the headlight, which its joint turns down."""
    up, around = np.radians(np.linspace(175, 52, 21)), np.radians(np.linspace(0, 180, 33))
    points = radius * np.stack(
        [
            np.outer(np.ones(21), np.cos(around)),
            np.outer(np.sin(up), np.sin(around)),
            np.outer(np.cos(up), np.sin(around)),
        ],
        -1,
    )
    return _net(points[::-1, ::-1])


def _wheel() -> Mesh:
    return pipe(
        [(-0.1, 0, 0), (-0.099, 0, 0), (0.099, 0, 0), (0.1, 0, 0)],
        (0, 0, 1),
        [0, 0.3, 0.3, 0],
        [0, 0.3, 0.3, 0],
        32,
    )


def _idle() -> Motion:
    """The motor runs: a small shake; the headlights look around, and blink."""
    glance = (
        (0.0, 0.0),
        (0.8, 0.0),
        (0.9, 9.0),
        (2.2, 9.0),
        (2.3, -8.0),
        (3.8, -8.0),
        (3.9, 0.0),
        (6.0, 0.0),
    )
    times, degrees = np.array(glance).T
    motion = {
        ("Body", "translation"): lambda t: np.stack([0 * t, 0.004 * np.sin(2 * np.pi * 3 * t), 0 * t], -1),
    }
    for side in ("Left", "Right"):
        motion[f"{side}.eye", "rotation"] = lambda t: turn_about((0, 1, 0), np.interp(t, times, degrees))
        motion[f"{side}.lid", "rotation"] = lambda t: turn_about((1, 0, 0), 52.0 * _shut(t))
    return motion


def _shut(t: Array) -> Array:
    """How far the lids are closed."""
    closed = [np.interp(t - at, (-0.10, -0.02, 0.04, 0.18), (0.0, 1.0, 1.0, 0.0)) for at in BLINKS]
    return np.asarray(np.max(closed, axis=0))
