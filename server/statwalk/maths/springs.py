"""Critically damped springs in closed form: stable at any step (kernels)."""

from __future__ import annotations

from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.scalar import exp


@inlined
def settled(offset: float, rate: float, eagerness: float, dt: float) -> Any:
    """Returns offset and rate of a critically damped spring `dt` seconds later; `eagerness` in 1/s: half of
    an offset at rest is gone after 1.678 / eagerness seconds.
    """
    drift, left = (rate + eagerness * offset) * dt, exp(-eagerness * dt)
    return (offset + drift) * left, (rate - eagerness * drift) * left
