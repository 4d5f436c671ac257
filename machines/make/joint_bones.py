"""The bones of the joints: A stands, B moves. B's joint is its origin."""

import numpy as np
from model import Model, material
from shapes import Mesh, about_z, ball, box, joined, lathe

A, B = material("bone A", "#8fa6b8", 0.5), material("bone B", "#e9803a", 0.4)
MARK = material("mark", "#fff3e0", 0.5)
UP = 0.62
"""metres: the length of bone A"""


def rod(length: float, radius: float = 0.045) -> Mesh:
    """A round rod along +Y with rounded ends."""
    ends = [(radius * float(np.cos(a)), radius * float(np.sin(a))) for a in np.linspace(0, np.pi / 2, 6)]
    below = [(r, -y) for r, y in reversed(ends)]
    return lathe([*below, *((r, length + y) for r, y in ends)], 20)


def flat(mesh: Mesh) -> Mesh:
    """The mesh along +X instead of +Y."""
    return mesh.turned(about_z(-90))


def tube(height: float, outer: float = 0.075, inner: float = 0.052) -> Mesh:
    """A tube along Y, around its middle."""
    half = height / 2
    edge = [(outer, -half), (outer, -half), (outer, half), (outer, half), (inner, half), (inner, half)]
    return lathe([*edge, (inner, -half), (inner, -half), (outer, -half)], 24)


def hinge_bones(model: Model) -> None:
    """Adds the bones of the joint."""
    model.part("A", rod(UP - 0.1), A)
    fork = [
        box((0.03, 0.2, 0.1), 0.01).turned(about_z(0)).moved(0, UP - 0.03, side * 0.075) for side in (-1, 1)
    ]
    quarter = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])
    pin = lathe([(0, -0.1), (0.03, -0.1), (0.03, 0.1), (0, 0.1)], 16).turned(quarter).moved(0, UP)
    model.part("A", joined(*fork, box((0.1, 0.04, 0.18), 0.01).moved(0, UP - 0.13), pin), A)
    model.part("B", joined(rod(0.46, 0.04), ball(0.06).moved(0, 0.46)), B)


def twist_bones(model: Model) -> None:
    """Adds the bones of the joint."""
    model.part("A", joined(rod(UP - 0.03), tube(0.12).moved(0, UP - 0.03)), A)
    model.part("B", joined(rod(0.46, 0.045), ball(0.06).moved(0, 0.46)), B)
    model.part(
        "B",
        joined(*(box((0.1, 0.03, 0.03), 0.008).moved(0.06, height) for height in (0.14, 0.26, 0.38))),
        MARK,
    )


def turn_bones(model: Model) -> None:
    """Adds the bones of the joint."""
    model.part("A", rod(UP), A)
    model.part("B", joined(tube(0.13), flat(rod(0.38, 0.038)).moved(0.09), ball(0.058).moved(0.5)), B)


def slide_bones(model: Model) -> None:
    """Adds the bones of the joint."""
    bars = [box((0.035, UP, 0.12), 0.01).moved(side * 0.075, UP / 2) for side in (-1, 1)]
    model.part("A", joined(*bars, box((0.19, 0.06, 0.12), 0.01).moved(0, 0.03)), A)
    model.part("B", joined(box((0.1, 0.62, 0.1), 0.015).moved(0, -0.2), ball(0.065).moved(0, 0.14)), B)


def screw_bones(model: Model) -> None:
    """Adds the bones of the joint."""
    turns = np.linspace(0, 2 * np.pi, 25)
    thread = [
        ball(0.018, 8).moved(0.05 * np.sin(9 * a), 0.05 + 0.85 * a / (2 * np.pi), 0.05 * np.cos(9 * a))
        for a in np.linspace(0, 2 * np.pi, 9 * len(turns))
    ]
    model.part("A", joined(rod(0.92, 0.05), *thread), A)
    model.part(
        "B", joined(tube(0.12, 0.1, 0.07), flat(rod(0.34, 0.035)).moved(0.1), ball(0.055).moved(0.46)), B
    )


def sleeve_bones(model: Model) -> None:
    """Adds the bones of the joint."""
    model.part("A", rod(1.05, 0.045), A)
    model.part("B", joined(tube(0.16, 0.09), flat(rod(0.34, 0.035)).moved(0.09), ball(0.055).moved(0.45)), B)


def piston_bones(model: Model) -> None:
    """Adds the bones of the joint."""
    model.part(
        "A", joined(tube(UP, 0.085, 0.055).moved(0, UP / 2), box((0.2, 0.04, 0.2), 0.01).moved(0, 0.02)), A
    )
    model.part("B", joined(rod(0.5, 0.045).moved(0, -0.3), ball(0.06).moved(0, 0.22)), B)
    model.part(
        "B", joined(*(box((0.09, 0.03, 0.03), 0.008).moved(0.06, height) for height in (0.06, 0.14))), MARK
    )


def ball_bones(model: Model) -> None:
    """Adds the bones of the joint."""
    socket = [
        (0.05, -0.12),
        (0.1, -0.06),
        (0.118, 0.0),
        (0.112, 0.03),
        (0.112, 0.03),
        (0.098, 0.02),
        (0.09, 0),
    ]
    model.part("A", joined(rod(UP - 0.12), lathe(socket, 28).moved(0, UP)), A)
    model.part("B", joined(ball(0.09, 24), rod(0.44, 0.035), ball(0.055).moved(0, 0.44)), B)
    model.part(
        "B", joined(*(box((0.07, 0.025, 0.025), 0.006).moved(0.045, height) for height in (0.2, 0.32))), MARK
    )


def book_bones(model: Model) -> None:
    """Adds the bones of the joint."""
    board = [box((0.86, 0.86, 0.04), 0.02).moved(0, UP - 0.1, 0.05), rod(0.4, 0.06).moved(0, 0, 0.05)]
    model.part("A", joined(*board), A)
    model.part("B", box((0.26, 0.34, 0.06), 0.012).moved(0, 0, -0.005), B)
    model.part(
        "B",
        joined(
            box((0.16, 0.02, 0.012), 0.004).moved(0, 0.09, -0.036),
            box((0.16, 0.02, 0.012), 0.004).moved(0, 0.04, -0.036),
        ),
        MARK,
    )
