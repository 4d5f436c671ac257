"""The six types of joints (FAQ Q4-Q10), as the FAQ draws them: bone A stands on a plinth, bone B moves."""

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from joint_bones import (
    UP,
    ball_bones,
    book_bones,
    hinge_bones,
    piston_bones,
    screw_bones,
    sleeve_bones,
    slide_bones,
    turn_bones,
    twist_bones,
)
from joint_letters import written
from model import Model, Motion, material
from shapes import Array, about_y, box
from statwalk.maths.clamp_table import JointLimit
from statwalk.rig.joint_types import Freedom, freedoms, joint
from statwalk.rig.joints import transform

STONE, INK = material("stone", "#cfd3d8", 0.9), material("letters", "#39424e", 0.7)
SECONDS, TOP = 8.0, 0.28
"""of a sweep; metres: height of the plinth"""
REACH = 1.2
"""of the sliders, as a multiple of the limits: what lies beyond is clamped"""
TRY_S = 0.05


class Stand(NamedTuple):
    """A joint on its plinth; `keys`: the joint in the machine's file."""

    letters: str
    keys: str
    limit: JointLimit
    bones: Callable[[Model], None]


def make_all(folder: Path) -> None:
    """Writes the model and the machine of each joint."""
    for name, stand in STANDS.items():
        place = folder / "joints" / name
        place.mkdir(parents=True, exist_ok=True)
        _model(name, stand).write(place / f"{name}.glb")
        (place / "machine.yaml").write_text(_machine(name, stand), encoding="utf-8")


def _model(name: str, stand: Stand) -> Model:
    model = Model(name)
    model.joint("Plinth")
    model.joint("A", "Plinth", (0.0, TOP, 0.0))
    model.joint("B", "A", (0.0, UP, 0.0))
    model.part("Plinth", box((0.52, TOP, 0.42), 0.02).moved(0, TOP / 2), STONE)
    letters = written(stand.letters).turned(about_y(180)).moved(0, TOP / 2, -0.215)
    model.part("Plinth", letters, INK)  # where the camera of a scene is
    stand.bones(model)
    free = freedoms(stand.limit)
    model.motion("sweep", SECONDS, _motion(stand.limit, lambda t: _sweep(stand.limit, t)))
    model.motion("rest", 1.0, _motion(stand.limit, lambda t: np.zeros((len(t), len(free)))))
    for place, (freedom, _positions) in enumerate(zip(free, _tries(stand), strict=True)):
        for number, value in enumerate(_tries(stand)[place]):
            model.motion(
                f"{freedom.name} {number}",
                TRY_S,
                _motion(stand.limit, _moved_to(len(free), place, _natural(freedom.is_angle, value))),
            )
    return model


def _moved_to(count: int, place: int, value: float) -> Callable[[Array], Array]:
    return lambda t: np.outer(t / TRY_S, value * np.eye(count)[place])


def _motion(limit: JointLimit, values: Callable[[Array], Array]) -> Motion:
    start = np.array([0.0, UP, 0.0])
    return {
        ("B", "translation"): lambda t: start + transform(limit, values(t))[0],
        ("B", "rotation"): lambda t: transform(limit, values(t))[1],
    }


def _sweep(limit: JointLimit, t: Array) -> Array:
    """Every degree of freedom through its whole range; a sphere's swing around its cone."""
    free, phase = freedoms(limit), 2 * np.pi * t / SECONDS
    if limit.type == "spherical":
        grown = np.sin(phase / 2) ** 2
        swings = [
            grown * freedom.high * wave(2 * phase)
            for freedom, wave in zip(free, (np.cos, np.sin), strict=False)
        ]
        return np.stack([*swings, np.pi * np.sin(phase)], -1)
    columns = []
    for place, freedom in enumerate(free):
        middle, half = (freedom.high + freedom.low) / 2, (freedom.high - freedom.low) / 2
        start = np.arcsin(np.clip(-middle / half, -1, 1))
        columns.append(middle + half * np.sin(phase * (1 + place) + start))
    return np.stack(columns, -1)


def _natural(is_angle: bool, value: float) -> float:
    return float(np.radians(value)) if is_angle else value


def _tries(stand: Stand) -> list[list[float]]:
    """For each degree of freedom the values of its clips, beyond the limits at both ends."""
    out = []
    for freedom in freedoms(stand.limit):
        low, high = (
            float(np.degrees(end)) if freedom.is_angle else end for end in (freedom.low, freedom.high)
        )
        middle, half = (low + high) / 2, (high - low) / 2 * REACH
        is_free = freedom.is_angle and high - low >= 359.9 and stand.limit.type != "helical"
        half = 179.0 if is_free else half
        count = max(2, int(np.ceil(2 * half / 100)) + 1) if freedom.is_angle else 2
        ends = {round(float(value), 3) for value in np.linspace(middle - half, middle + half, count)}
        out.append(sorted(ends | {0.0}))
    return out


def _machine(name: str, stand: Stand) -> str:
    free, tries = freedoms(stand.limit), _tries(stand)
    names = [freedom.name + ("_deg" if freedom.is_angle else "") for freedom in free]
    text = [
        "# Made by machines/make. SHOW moves every degree of freedom through its range; TRY listens to the",
        "# sliders, which reach beyond the limits: what lies beyond is clamped.",
        "semantics: 1",
        f"title: A {stand.limit.type} joint, {stand.letters}",
        f"description: Press s to see its range; drag its {_handles(free)}, or press t and move the sliders.",
        f"character: {name}.glb",
        "initial: SHOW",
        "defaults: {blend: 0.4, buffer: 0}",
        "joints:",
        f"  B: {stand.keys}",
        "parameters:",
        *(
            f"  {key}: {{default: 0, min: {values[0]:g}, max: {values[-1]:g}, smooth: 0.1, "
            f"handle: {{joint: B, freedom: {freedom.name}, event: TRY}}}}"
            for key, freedom, values in zip(names, free, tries, strict=True)
        ),
        "states:",
        "  SHOW: {motion: sweep, loop: true}",
        "  TRY:  {motion: rest, loop: true}",
        "table: |",
        "  state | SHOW | TRY | END",
        "  SHOW  |      | TRY |",
        "  TRY   | SHOW |     |",
        "keys:",
        "  s: {press: SHOW}",
        "  t: {press: TRY}",
        "layers:",
    ]
    for freedom, key, values in zip(free, names, tries, strict=True):
        clips = ", ".join(f"{freedom.name} {number}: {value:g}" for number, value in enumerate(values))
        text += [
            f"  {freedom.name}:",
            "    mask: [B]",
            "    mode: additive",
            "    initial: AWAY",
            "    states:",
            "      AWAY: {motion: none}",
            f"      HERE: {{motion: {{over: {key}, clips: {{{clips}}}}}}}",
            "    table: |",
            "      state | SHOW | TRY  | END",
            "      AWAY  |      | HERE |",
            "      HERE  | AWAY |      |",
        ]
    return "\n".join(text) + "\n"


def _handles(free: Sequence[Freedom]) -> str:
    """A handle for each degree of freedom; two of a sphere or a plane share one."""
    names = {freedom.name.removesuffix("_x").removesuffix("_z") for freedom in free}
    return "handle" if len(names) == 1 else f"{len(names)} handles"


def _deg(*ends: float) -> tuple[float, float]:
    low, high = np.radians(ends)
    return float(low), float(high)


def _stand(
    letters: str, kind: str, bones: Any, ranges: Mapping[str, tuple[float, float]], keys: str, **more: Any
) -> Stand:
    return Stand(letters, f"{{type: {kind}, {keys}}}", joint(kind, ranges, **more), bones)


STANDS = {
    "hinge": _stand(
        "R1", "revolute", hinge_bones, {"angle": _deg(-80, 80)},
        "form: hinge, axis: [0, 0, 1], angle_deg: [-80, 80]", form="hinge", axis=(0, 0, 1),
    ),
    "twist": _stand(
        "R2", "revolute", twist_bones, {"angle": _deg(-90, 90)}, "form: twist, angle_deg: [-90, 90]",
        form="twist",
    ),
    "turn": _stand(
        "R3", "revolute", turn_bones, {"angle": _deg(-120, 120)}, "form: turn, angle_deg: [-120, 120]",
        form="turn",
    ),
    "prismatic": _stand("P", "prismatic", slide_bones, {"slide": (-0.1, 0.25)}, "slide: [-0.1, 0.25]"),
    "helical": _stand(
        "H", "helical", screw_bones, {"angle": _deg(-720, 720)}, "angle_deg: [-720, 720], pitch: 0.1",
        pitch=0.1,
    ),
    "cylindrical": _stand(
        "RP", "cylindrical", sleeve_bones, {"angle": _deg(-90, 90), "slide": (-0.25, 0.3)},
        "form: offset, angle_deg: [-90, 90], slide: [-0.25, 0.3]", form="offset",
    ),
    "coaxial": _stand(
        "~RP", "cylindrical", piston_bones, {"angle": _deg(-90, 90), "slide": (0.0, 0.25)},
        "form: coaxial, angle_deg: [-90, 90], slide: [0, 0.25]", form="coaxial",
    ),
    "spherical": _stand(
        "3R", "spherical", ball_bones, {"swing_x": _deg(-60, 60), "swing_z": _deg(-40, 40)},
        "swing_x_deg: [-60, 60], swing_z_deg: [-40, 40]",
    ),
    "planar": _stand(
        "PPR", "planar", book_bones,
        {"slide_x": (-0.25, 0.25), "slide_z": (-0.2, 0.2), "angle": _deg(-45, 45)},
        "axis: [0, 0, 1], side: [1, 0, 0], slide_x: [-0.25, 0.25], slide_z: [-0.2, 0.2], "
        "angle_deg: [-45, 45]", axis=(0, 0, 1), side=(1, 0, 0),
    ),
}  # fmt: skip
