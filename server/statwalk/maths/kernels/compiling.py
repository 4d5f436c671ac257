"""How kernels are compiled: to machine code kept on disk, strictly by the rules of IEEE arithmetic, without the interpreter's lock.

No fast-math: sums keep their order and nothing is fused, so a kernel gives the bits that its NumPy twin gives, on every processor.
Kernels neither allocate nor slice (`_nrt=False`): references would be counted in the innermost loop. Buffers come from the caller.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

from numba import njit, types

Function = TypeVar("Function", bound=Callable[..., Any])

OPTIONS = {"nogil": True, "error_model": "numpy", "boundscheck": False, "_nrt": False}


FLOAT, INT, LONG = types.float32, types.int32, types.int64


def read(kind: Any, axes: int) -> Any:
    """The type of a contiguous array that a kernel only reads: locked ones are welcome."""
    return types.Array(kind, axes, "C", readonly=True)


def write(kind: Any, axes: int) -> Any:
    """The type of a contiguous array that a kernel writes."""
    return types.Array(kind, axes, "C")


def kernel(*arguments: Any, returns: Any = types.void) -> Callable[[Function], Function]:
    """Compiles the function for arguments of those types at once, or takes it from the disk.

    The compiled code is kept beside the source, else in the user's cache folder, or in NUMBA_CACHE_DIR; where none of them can be
    written it is compiled anew by each process. What is kept goes by the time of the kernel's own file: who changes `lanes.py` touches
    the kernels too.
    """
    signature = returns(*arguments)

    def compiled(function: Function) -> Function:
        try:
            made: Function = njit(signature, cache=True, **OPTIONS)(function)
        except (RuntimeError, OSError):  # no folder to keep it in, or no room there
            made = njit(signature, **OPTIONS)(function)
        return made

    return compiled


def inlined(function: Function) -> Function:
    """A part of kernels, compiled into each of them."""
    made: Function = njit(inline="never", forceinline=True, **OPTIONS)(function)
    return made
