"""Kernels of the tests themselves: compiled when a test calls them, since no folder keeps their code."""

from collections.abc import Callable
from functools import cache, wraps
from typing import Any

from numba import types
from statwalk.maths.compiling import kernel


def late_kernel(*arguments: Any, returns: Any = types.void) -> Callable[..., Any]:
    """Makes the function a kernel at its first call: a process that only collects tests compiles none."""

    def waiting(function: Any) -> Any:
        compiled = cache(kernel(*arguments, returns=returns))

        @wraps(function)
        def call(*values: Any) -> Any:
            return compiled(function)(*values)

        return call

    return waiting
