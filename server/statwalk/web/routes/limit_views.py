"""The limits of joints as the API shows them, in degrees and metres."""

from __future__ import annotations

import math
from typing import Literal

from statwalk.character.role import Role
from statwalk.maths.clamp_kinds import CONE, EULER, HINGE, RANGE
from statwalk.maths.clamp_table import JointLimit
from statwalk.rig.joint_types import Freedom, freedoms, symbol
from statwalk.web.schemas.machine import FreedomView, LimitView

Shape = Literal["free", "hinge", "cone", "range", "axes"]
_SHAPES: dict[int, Shape] = {HINGE: "hinge", CONE: "cone", RANGE: "range", EULER: "axes"}


def limit_views(role: Role) -> list[LimitView]:
    """Returns the limits of a role's joints, in the order of the joints."""
    return [_view(role, joint, limit) for joint, limit in sorted(role.limits.items())]


def _view(role: Role, joint: int, limit: JointLimit) -> LimitView:
    rest = role.character.bind_pose
    return LimitView(
        joint=role.character.skeleton.names[joint],
        type=limit.type,
        form=limit.form,
        symbol=symbol(limit),
        shape=_SHAPES.get(limit.kind, "free"),
        frame=list(limit.frame),
        rest=[*rest.translation[joint].tolist(), *rest.rotation[joint].tolist()],
        pitch=2 * math.pi * limit.pitch,
        freedoms=[_freedom(freedom) for freedom in freedoms(limit)],
    )


def _freedom(freedom: Freedom) -> FreedomView:
    def shown(value: float) -> float | None:
        if not math.isfinite(value):
            return None
        return math.degrees(value) if freedom.is_angle else value

    return FreedomView(
        name=freedom.name, is_angle=freedom.is_angle, minimum=shown(freedom.low), maximum=shown(freedom.high)
    )
