"""Named tuples by reference: compiled code passes one pointer instead of a hundred arrays with their shapes.

A kernel takes a named tuple of arrays by value, as Python passes it; `by_reference` stores it on the stack
for the functions that the kernel calls. They read its fields as before. A call then costs as little as in C,
and the compiler need not carry every array through every call.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar
from zlib import crc32

from numba import types
from numba.core import cgutils
from numba.core.typing.templates import AttributeTemplate
from numba.extending import infer_getattr, intrinsic, lower_getattr_generic, models, register_model

from statwalk.maths import compiling
from statwalk.maths.compiling import IS_COMPILED, OPTIONS
from statwalk.maths.kernel_parts import part

Function = TypeVar("Function", bound=Callable[..., Any])


class Reference(types.Type):
    """The numba type of a named tuple that is passed by reference."""

    def __init__(self, fields: Any) -> None:
        self.fields = fields
        super().__init__(
            name=f"{fields.instance_class.__name__}@{crc32(str(fields).encode()):08x}"
        )  # it becomes part of many symbols

    def field(self, name: str) -> tuple[int, Any]:
        """Returns index and type of a field; a nested named tuple is a reference too."""
        place = self.fields.fields.index(name)
        kind = self.fields.types[place]
        return place, Reference(kind) if isinstance(kind, types.BaseTuple) else kind


@register_model(Reference)
class _ReferenceModel(models.PrimitiveModel):
    def __init__(self, manager: Any, kind: Reference) -> None:
        super().__init__(manager, kind, manager.lookup(kind.fields).get_value_type().as_pointer())


@infer_getattr
class _ReferenceFields(AttributeTemplate):
    key = Reference

    def generic_resolve(self, reference: Reference, name: str) -> Any:
        return reference.field(name)[1]


@lower_getattr_generic(Reference)
def _read_field(context: Any, builder: Any, kind: Reference, value: Any, name: str) -> Any:  # noqa: ARG001
    place, field_type = kind.field(name)
    pointer = cgutils.gep_inbounds(builder, value, 0, place)
    return pointer if isinstance(field_type, Reference) else builder.load(pointer)


@intrinsic
def _by_reference(context: Any, fields: Any) -> Any:  # noqa: ARG001
    def put(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:  # noqa: ARG001
        return cgutils.alloca_once_value(builder, arguments[0])

    return Reference(fields)(fields), put


def _itself(fields: Any) -> Any:
    return fields


by_reference = _by_reference if IS_COMPILED else _itself
"""A named tuple for the functions that a kernel calls; in plain Python the named tuple itself"""


def called(function: Function) -> Function:
    """Compiles a part of kernels once, to be called: for long functions, or functions with many callers."""
    return _widening(part(function, is_inlined=False, **OPTIONS)) if IS_COMPILED else function


def inlined(function: Function) -> Function:
    """Compiles a part of kernels into each of them: for short functions, or functions called for
    every actor.
    """
    return _widening(compiling.inlined(function)) if IS_COMPILED else function


def _widening(dispatcher: Any) -> Any:
    """Compiles once for all types of whole numbers: a version for each type and each constant would take
    minutes.
    """
    template_of = dispatcher.get_call_template

    def get_call_template(arguments: Any, keywords: Any) -> Any:
        return template_of(tuple(_widened(argument) for argument in arguments), keywords)

    dispatcher.get_call_template = get_call_template
    return dispatcher


def _widened(kind: Any) -> Any:
    kind = types.unliteral(kind)
    return (
        types.int64
        if (isinstance(kind, types.Integer) and kind.bitwidth < 64) or isinstance(kind, types.Boolean)
        else kind
    )
