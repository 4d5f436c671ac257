"""A goose on the wing: body, neck and head in one, two wings that bend along their span."""

import numpy as np
from model import Model, Motion, material, turn_about
from shapes import Array, ball, joined, loft, mirrored, wing

GREY = material("grey", "#8b8174", 0.8)
PALE = material("pale", "#e8e2d6", 0.85)
DARK = material("dark", "#3a342f", 0.8)
ORANGE = material("orange", "#e58a2c", 0.5)
FLAP_S, GLIDE_S = 0.6, 2.4
INNER, OUTER, TIP = 0.1, 0.42, 0.78


def make() -> Model:
    """The goose; it flies along +Z and is about a metre long, its span 2 m."""
    model = Model("goose")
    model.joint("Body")
    model.joint("Neck", "Body", (0.0, 0.02, 0.26))
    for side, name in ((1, "Left"), (-1, "Right")):
        model.joint(f"{name}.arm", "Body", (side * INNER, 0.08, 0.08))
        model.joint(f"{name}.hand", f"{name}.arm", (side * (OUTER - INNER), 0.0, 0.0))
        model.joint(f"{name}.tip", f"{name}.hand", (side * (TIP - OUTER), 0.0, 0.0))
    _trunk(model)
    _wings(model)
    model.motion("flap", FLAP_S, _beating(FLAP_S, 42.0, 0.05))
    model.motion("glide", GLIDE_S, _beating(GLIDE_S, 5.0, 0.012, lift=8.0))
    return model


def _trunk(model: Model) -> None:
    spine = [
        (0, 0.03, -0.5),
        (0, 0.03, -0.46),
        (0, 0.02, -0.36),
        (0, 0.0, -0.2),
        (0, -0.02, 0.0),
        (0, -0.01, 0.16),
        (0, 0.02, 0.27),
        (0, 0.035, 0.33),
    ]
    model.part(
        "Body",
        loft(
            spine,
            [0, 0.05, 0.08, 0.13, 0.16, 0.14, 0.08, 0],
            [0, 0.015, 0.05, 0.11, 0.145, 0.12, 0.07, 0],
            20,
        ),
        GREY,
    )
    belly = [(0, -0.02, -0.4), (0, -0.03, -0.3), (0, -0.05, -0.1), (0, -0.055, 0.06), (0, -0.03, 0.2)]
    model.part("Body", loft(belly, [0, 0.06, 0.125, 0.12, 0], [0, 0.06, 0.11, 0.1, 0], 16), PALE)
    tail = [(0, 0.03, -0.62), (0, 0.03, -0.58), (0, 0.03, -0.45), (0, 0.03, -0.38)]
    model.part("Body", loft(tail, [0, 0.1, 0.06, 0], [0, 0.008, 0.02, 0], 12), DARK)
    neck = [
        (0, -0.01, -0.06),
        (0, 0, 0.0),
        (0, 0.02, 0.12),
        (0, 0.04, 0.26),
        (0, 0.05, 0.36),
        (0, 0.05, 0.43),
        (0, 0.045, 0.48),
    ]
    model.part(
        "Neck",
        loft(neck, [0, 0.07, 0.045, 0.036, 0.042, 0.036, 0], [0, 0.065, 0.045, 0.038, 0.047, 0.038, 0], 16),
        DARK,
    )
    cheeks = [
        loft(
            [(side * 0.034, 0.035, 0.33), (side * 0.036, 0.04, 0.37), (side * 0.034, 0.045, 0.41)],
            [0, 0.012, 0],
            [0, 0.03, 0],
            10,
        )
        for side in (-1, 1)
    ]
    model.part("Neck", joined(*cheeks), PALE)
    beak = [(0, 0.04, 0.45), (0, 0.04, 0.47), (0, 0.03, 0.53), (0, 0.025, 0.56)]
    model.part("Neck", loft(beak, [0, 0.024, 0.016, 0], [0, 0.022, 0.01, 0], 12), ORANGE)
    model.part(
        "Neck",
        joined(*(ball(0.008, 8).moved(side * 0.034, 0.065, 0.405) for side in (-1, 1))),
        material("eye", "#0b0a09", 0.2),
    )


def _wings(model: Model) -> None:
    span = np.array([0.04, 0.1, 0.2, 0.32, 0.42, 0.52, 0.64, 0.78, 0.9, 0.98, 1.02])
    front = 0.16 - 0.05 * (span / 1.02) ** 2 - 0.14 * np.clip(span - 0.6, 0, 1) ** 1.5
    back = np.array([-0.16, -0.18, -0.19, -0.185, -0.175, -0.17, -0.165, -0.16, -0.13, -0.08, -0.02])
    thick = np.array([0.035, 0.035, 0.03, 0.026, 0.024, 0.02, 0.016, 0.012, 0.009, 0.006, 0.001])
    cover = wing(span, front.tolist(), (back * 0.55).tolist(), (thick * 1.25).tolist())
    feather = wing(span, (front - 0.03).tolist(), back.tolist(), (thick * 0.6).tolist())
    for name, flip in (("Left", False), ("Right", True)):
        for mesh, stuff in ((cover, GREY), (feather, DARK)):
            side = mirrored(mesh) if flip else mesh
            model.skinned(side.moved(0, 0.08, 0.08), stuff, _shares(name, np.abs(side.points[:, 0])))


def _shares(name: str, out: Array) -> dict[str, Array]:
    """How much of each joint a place of the wing follows, by its distance from the middle."""
    root = np.clip((INNER + 0.03 - out) / 0.06, 0, 1)
    hand = np.clip((out - OUTER + 0.12) / 0.24, 0, 1)
    tip = np.clip((out - TIP + 0.12) / 0.24, 0, 1)
    return {
        "Body": root,
        f"{name}.arm": (1 - root) * (1 - hand),
        f"{name}.hand": hand * (1 - tip),
        f"{name}.tip": tip,
    }


def _beating(seconds: float, degrees: float, bob: float, lift: float = 4.0) -> Motion:
    """Wings go up and down once; the outer parts follow later, the body bobs against them, the head stays."""

    def wave(t: Array, late: float) -> Array:
        return np.sin(2 * np.pi * (t / seconds - late))

    motion = {
        ("Body", "translation"): lambda t: np.stack([0 * t, -bob * wave(t, 0.02), 0 * t], -1),
        ("Neck", "translation"): lambda t: np.stack(
            [0 * t, 0.02 + 0.7 * bob * wave(t, 0.02), 0 * t + 0.26], -1
        ),
    }
    for side, name in ((1, "Left"), (-1, "Right")):
        for part, size, late in (("arm", 1.0, 0.0), ("hand", 0.62, 0.1), ("tip", 0.45, 0.2)):
            rest = lift if part == "arm" else -0.35 * lift
            motion[f"{name}.{part}", "rotation"] = lambda t, side=side, size=size, late=late, rest=rest: (
                turn_about((0, 0, 1), side * (rest + degrees * size * wave(t, late)))
            )
    return motion
