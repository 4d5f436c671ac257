"""Compiles kernels: to machine code kept on disk, strictly by the rules of IEEE arithmetic, without the
interpreter's lock.

No fast-math: sums keep their order and nothing is fused, so a kernel gives the same bits on every processor.
Kernels neither allocate nor slice (`_nrt=False`): references would be counted in the innermost loop. Buffers
come from the caller. With STATWALK_COMPILED=0 nothing is compiled: kernels, inlined functions and callees
stay plain Python. Code per actor then gives the same numbers, slowly, under a debugger; code over sixteen
lanes can't run without a compiler.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO, Any, TypeVar

from numba import config, extending, njit, types
from numba.core import caching

from statwalk.errors import StatwalkError
from statwalk.maths.code_folder import PACKAGE, folder
from statwalk.maths.kernel_parts import part
from statwalk.maths.kernel_stack import KernelCompiler

try:
    import fcntl
except ImportError:  # Windows: two processes may compile the same kernel
    fcntl = None  # type: ignore[assignment]

Function = TypeVar("Function", bound=Callable[..., Any])

OPTIONS = {"nogil": True, "error_model": "numpy", "boundscheck": False, "_nrt": False}
IS_COMPILED = os.environ.get("STATWALK_COMPILED", "1") != "0" and not config.DISABLE_JIT
NOT_COMPILED = (
    "poses need compiled code, and the compiler is switched off here: unset STATWALK_COMPILED and "
    "NUMBA_DISABLE_JIT"
)
KERNELS: list[Any] = []
"""the kernels of this process, in the order of their imports"""
LISTENERS: list[Callable[[int, str], None]] = []
"""called with the number and name of a kernel before it is compiled"""
FLOAT, INT, LONG = types.float32, types.int32, types.int64


def read(kind: Any, axes: int) -> Any:
    """Returns the type of a contiguous array that a kernel only reads; read-only arrays fit."""
    return types.Array(kind, axes, "C", readonly=True)


def write(kind: Any, axes: int) -> Any:
    """Returns the type of a contiguous array that a kernel writes."""
    return types.Array(kind, axes, "C")


def kernel(*arguments: Any, returns: Any = types.void) -> Callable[[Function], Function]:
    """Compiles the function at once for arguments of these types, or loads its code from the disk (see
    `code_folder`).
    """

    def compiled(function: Function) -> Function:
        if not IS_COMPILED:
            return function
        dispatcher: Any = njit(pipeline_class=KernelCompiler, **OPTIONS)(function)
        dispatcher._cache = _kept_code(function)
        dispatcher.compile(returns(*arguments))
        dispatcher.disable_compile()
        KERNELS.append(dispatcher)
        compiled_function: Function = dispatcher
        return compiled_function

    return compiled


def inlined(function: Function) -> Function:
    """Compiles the function into each kernel that calls it."""
    if not IS_COMPILED:
        return function
    compiled_function: Function = part(function, is_inlined=True, **OPTIONS)
    return compiled_function


def intrinsic(function: Callable[..., Any]) -> Any:
    """Makes the function an instruction inside kernels.

    :raises StatwalkError: when it is called while the compiler is switched off.
    """
    return extending.intrinsic(function) if IS_COMPILED else _refused


def _refused(*_arguments: Any) -> Any:
    raise StatwalkError(NOT_COMPILED)


@contextmanager
def announced(listener: Callable[[int, str], None]) -> Iterator[None]:
    """Calls the listener before each kernel is compiled, with the kernel's number in this process and its
    name.
    """
    LISTENERS.append(listener)
    try:
        yield
    finally:
        LISTENERS.remove(listener)


def _kept_code(function: Any) -> Any:
    is_ours = _path(function.__code__.co_filename).is_relative_to(
        PACKAGE
    )  # the folder's name depends on the files of the package alone
    return _KeptCode(function) if is_ours else caching.NullCache()


def _path(name: str) -> Path:
    return Path(name).resolve()


class _Locator(caching._CacheLocator):
    """Tells numba the folder of a kernel's code: one folder for all, by module and name."""

    def __init__(self, path: str) -> None:
        self._py_file, self._folder = path, folder()

    @classmethod
    def from_function(cls, _function: Any, path: str) -> _Locator:
        return cls(path)

    def ensure_cache_path(self) -> None:
        self._folder.mkdir(parents=True, exist_ok=True)

    def get_cache_path(self) -> str:
        return str(self._folder)

    def get_source_stamp(self) -> str:
        return self._folder.name

    def get_disambiguator(self) -> str:
        return "-".join(_path(self._py_file).relative_to(PACKAGE).parent.parts)


class _Place(caching.CompileResultCacheImpl):
    _locator_classes = [_Locator]  # noqa: RUF012 - numba's form


class _KeptCode(caching.FunctionCache):
    _impl_class = _Place
    _turn: IO[bytes] | None = None

    def load_overload(self, signature: Any, context: Any) -> Any:
        overload = self._load(signature, context)
        if overload is None:
            self._wait_for_turn()
            overload = self._load(signature, context)
        if overload is None:
            for listener in LISTENERS:
                listener(len(KERNELS) + 1, self._py_func.__name__)
        else:
            self._end_turn()
        return overload

    def save_overload(self, signature: Any, data: Any) -> None:
        with suppress(OSError):  # a full disk, or a folder of another user: compiled for this process alone
            super().save_overload(signature, data)
        self._end_turn()

    def _load(self, signature: Any, context: Any) -> Any:
        try:
            return super().load_overload(signature, context)
        except Exception:  # a damaged file
            with suppress(OSError):
                self.flush()
            return None

    def _wait_for_turn(self) -> None:
        """Waits while another process compiles this kernel."""
        if fcntl is None:
            return
        with suppress(OSError):
            self._turn = open(Path(self._cache_path) / f"{self._impl.filename_base}.turn", "wb")  # noqa: SIM115 - until saved
            fcntl.flock(self._turn, fcntl.LOCK_EX)

    def _end_turn(self) -> None:
        if self._turn is not None:
            self._turn.close()
            self._turn = None
