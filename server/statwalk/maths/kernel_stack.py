"""Begins the stack of kernels at a multiple of 64 bytes.

A kernel keeps lanes on the stack if it has more of them than the processor has registers. Its caller leaves
the stack at any multiple of 16 bytes: in some processes, lanes would lie across two cache lines, and skinning
a crowd took 13 % longer.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba.core import codegen, compiler, typed_passes
from numba.core.compiler_machinery import register_pass

BYTES = 64
"""of a cache line, and of sixteen lanes"""


class KernelLibrary(codegen.JITCodeLibrary):
    """Code whose functions align their stacks."""

    def add_ir_module(self, ir_module: ir.Module) -> None:
        """Takes in code, and gives its functions the attribute."""
        for function in ir_module.functions:
            function.attributes.alignstack = BYTES
            function.attributes.add("nounwind")  # llvmlite writes no attributes of an empty set
        super().add_ir_module(ir_module)


@register_pass(mutates_CFG=True, analysis_only=False)
class _KernelLowering(typed_passes.NativeLowering):
    """Lowers a kernel into a `KernelLibrary`."""

    _name = "statwalk_kernel_lowering"

    def run_pass(self, state: Any) -> bool:
        state.library = KernelLibrary(state.targetctx.codegen(), state.func_id.func_qualname)
        state.library.enable_object_caching()
        return bool(super().run_pass(state))


class KernelCompiler(compiler.CompilerBase):
    """Compiles a kernel (numba's `pipeline_class`)."""

    def define_pipelines(self) -> list[Any]:
        """Returns numba's own steps, with the lowering of kernels."""
        return [lowered_by(_KernelLowering, self.state)]


def lowered_by(lowering: Any, state: Any) -> Any:
    """Returns numba's own steps with another lowering."""
    pipeline = compiler.DefaultPassBuilder.define_nopython_pipeline(state)
    pipeline.add_pass_after(lowering, typed_passes.NativeLowering)
    pipeline.passes = [step for step in pipeline.passes if step[0] is not typed_passes.NativeLowering]
    pipeline.finalize()
    return pipeline
