"""Spherical cubics through key rotations (KF4; Shoemake 1987), with keys at uneven times."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from statwalk.maths.arrays import Floats
from statwalk.maths.quat import conjugate, from_rotation_vector, mul, slerp, to_rotation_vector


def squad(q0: Floats, s0: Floats, s1: Floats, q1: Floats, f: ArrayLike) -> Floats:
    """Interpolates from `q0` (f = 0) to `q1` (f = 1) along a spherical cubic with inner points `s0`, `s1`
    from `squad_tangents`: the one out of `q0`, and the one into `q1`.

    KF4, Shoemake 1987.
    """
    part = np.asarray(f, q0.dtype)
    return slerp(slerp(q0, q1, part), slerp(s0, s1, part), 2 * part * (1 - part))


def squad_tangents(
    before: Floats, q: Floats, after: Floats, since: Floats, until: Floats
) -> tuple[Floats, Floats]:
    """Returns the inner points into and out of key `q`, with which the motion passes `q` at one speed;
    `since` (…) seconds from the key before it, `until` (…) to the key after it.

    The speed is that of the parabola through the three keys. Where the times are equal both points are
    Shoemake's.
    """
    back, since, until = conjugate(q), since[..., None], until[..., None]
    come, go = to_rotation_vector(mul(back, before)), to_rotation_vector(mul(back, after))
    speed = (go * (since / until) - come * (until / since)) / (since + until)
    into, out_of = (speed * since + come) * -0.5, (speed * until - go) * 0.5
    return mul(q, from_rotation_vector(into)), mul(q, from_rotation_vector(out_of))
