"""Keeps functions that only kernels call as the compiler's text, until a kernel takes them in.

numba optimises each function and makes machine code of it, and does both again in every caller. Three
quarters of the time went into code that nobody ran. Here only kernels are optimised, each with all its parts.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numba import njit
from numba.core import compiler, typed_passes
from numba.core.compiler_machinery import register_pass

from statwalk.errors import StatwalkError
from statwalk.maths.kernel_stack import KernelLibrary, lowered_by


def part(function: Callable[..., Any], is_inlined: bool, **options: Any) -> Any:
    """Compiles a function into each kernel that calls it: in place of the call, or as a function to call."""
    wrappers = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}
    # said outright: numba would also inline what an inlined function calls
    return njit(forceinline=is_inlined, pipeline_class=_PartCompiler, **wrappers, **options)(function)


class _PartLibrary(KernelLibrary):
    """Code that is linked into kernels, and not made machine code for itself."""

    def _optimize_functions(self, module: Any) -> None:
        module.data_layout = self._codegen._data_layout

    def _optimize_final_module(self) -> None:
        pass

    def _finalize_final_module(self) -> None:
        self._finalized = True


@register_pass(mutates_CFG=True, analysis_only=False)
class _PartLowering(typed_passes.NativeLowering):
    """Lowers a part to text. Inlined parts bear `alwaysinline`; all others stay functions of their own."""

    _name = "statwalk_part_lowering"

    def run_pass(self, state: Any) -> bool:
        state.library = _PartLibrary(state.targetctx.codegen(), state.func_id.func_qualname)
        state.flags.no_compile = True
        super().run_pass(state)
        state.library.finalize()
        function = state.cr.fndesc
        if not state.flags.forceinline:
            state.library.get_function(function.llvm_func_name).add_function_attribute("noinline")
        nothing: dict[str, None] = {}
        key = nothing.__getitem__  # numba finds a compiled function by its built-in function; a part has none
        state.targetctx.insert_user_function(key, function, [state.library])
        state.cr = state.cr._replace(cfunc=key)
        return True


class _PartCompiler(compiler.CompilerBase):
    """Compiles a part while a kernel that calls it is compiled (numba's `pipeline_class`).

    :raises StatwalkError: when a part is called from Python.
    """

    def define_pipelines(self) -> list[Any]:
        if len(compiler.ConfigStack()) < 2:  # no kernel is being compiled
            raise StatwalkError(f"{self.state.func_id.func_name} is a part of kernels: call it in a kernel")
        return [lowered_by(_PartLowering, self.state)]
