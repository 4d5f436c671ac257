"""Which inner loops run: compiled ones, or NumPy where numba is not to be had or not wanted (STATWALK_KERNELS=numpy)."""

from __future__ import annotations

import logging
import os
from collections.abc import Callable
from functools import cache
from importlib import import_module
from typing import NamedTuple

VARIABLE = "STATWALK_KERNELS"
MODULES = ("skinning", "morphing", "hierarchy", "reading")
LOG = logging.getLogger(__name__)


class Kernels(NamedTuple):
    """The compiled kernels; what they take stands where they are defined."""

    palette: Callable[..., None]
    skinned: Callable[..., None]
    morphed: Callable[..., None]
    inbetween: Callable[..., None]
    placed: Callable[..., None]
    within: Callable[..., bool]
    unit_length: Callable[..., bool]
    normalised: Callable[..., int]
    gathered: Callable[..., None]
    constant: Callable[..., None]
    lines: Callable[..., None]
    turns: Callable[..., None]


@cache
def kernels() -> Kernels | None:
    """The compiled kernels, or None for NumPy. The first call imports numba and takes the kernels from the disk, half a second; the very
    first on a machine compiles them, several seconds. Nothing else does either, so who never asks never waits.
    """
    if os.environ.get(VARIABLE) == "numpy":
        return None
    try:
        skinning, morphing, hierarchy, reading = (import_module(f"statwalk.maths.kernels.{name}") for name in MODULES)
    except Exception as error:  # whatever ails numba here, vertices there must be
        missing = isinstance(error, ImportError)
        LOG.log(logging.INFO if missing else logging.WARNING, "skinning with NumPy: %s: %s", type(error).__name__, error)
        return None
    return Kernels(
        *(skinning.palette, skinning.skinned, morphing.morphed, morphing.inbetween, hierarchy.placed),
        *(reading.within, reading.unit_length, reading.normalised, reading.gathered, reading.constant),
        *(reading.lines, reading.turns),
    )


def loaded() -> Kernels | None:
    """The compiled kernels where somebody has asked for them before: what is done once, like reading a file, does not wait for them."""
    return kernels() if kernels.cache_info().currsize else None
