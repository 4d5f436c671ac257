"""Running hashes in exact integer arithmetic, compiled: of the rows of arrays of any type, and of floats
sixteen actors at a time.

Every step is a bijection of the hash for a given word, and of the word for a given hash: no bit is lost, and
the order counts. A row's hash is one word of 64 bits. A lane's hash is two words of 32 bits, mixed with
different constants, which `lane_hash` combines.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import types

from statwalk.maths.compiling import inlined, intrinsic
from statwalk.maths.random import GOLDEN, scrambled
from statwalk.maths.simd.lane_bits import INT64, stirring, word_at, word_of
from statwalk.maths.simd.lane_functions import either

LOW, HALF_WORD = np.uint64(0xFFFFFFFF), np.uint64(32)
STIR, ROTATE, UNROTATE = np.uint64(GOLDEN), np.uint64(29), np.uint64(35)


@inlined
def _hash_word(before: Any, word: Any) -> Any:
    """The hash after one more word, both uint64."""
    mixed = before ^ word
    return ((mixed << ROTATE) | (mixed >> UNROTATE)) * STIR


@inlined
def hash_span(before: Any, array: Any, first: int, count: int) -> Any:
    """Returns the hash after `count` numbers of an array from a flat index on."""
    for index in range(first, first + count):
        before = _hash_word(before, word_at(array, index))
    return before


@inlined
def hash_row(before: Any, array: Any, row: int) -> Any:
    """Returns the hash after an actor's row of an array (N, ...)."""
    width = 1
    for axis in range(1, array.ndim):
        width *= array.shape[axis]
    return hash_span(before, array, row * width, width)


@intrinsic
def hash_rows(typing: Any, before: Any, arrays: Any, row: Any) -> Any:
    """hash_rows(before, arrays, row): `hash_row` of each array of a tuple or named tuple, in their order."""
    row_types = [types.uint64(types.uint64, kind, types.int64) for kind in arrays.types]
    hashers = [typing.resolve_function_type(types.Dispatcher(hash_row), sig.args, {}) for sig in row_types]

    def code(context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        value, rows = args[0], builder.sext(args[2], INT64) if args[2].type != INT64 else args[2]
        for number, hasher in enumerate(hashers):
            call = context.get_function(types.Dispatcher(hash_row), hasher)
            value = call(builder, [value, builder.extract_value(args[1], number), rows])
        return value

    return types.uint64(types.uint64, arrays, types.int64), code


stir_low, stir_high = stirring(15, 0x9E3779B1), stirring(11, 0x85EBCA77)
"""the steps of the lower and of the upper half of a lane's hash"""


@inlined
def stir(before: Any, value: Any) -> Any:
    """Returns the two halves of sixteen hashes after sixteen more floats."""
    return stir_low(before[0], value), stir_high(before[1], value)


@inlined
def stir_where(mask: Any, before: Any, value: Any) -> Any:
    """Returns `stir` in lanes with a mask above 0; the other hashes stay."""
    low, high = stir(before, value)
    return either(mask, low, before[0]), either(mask, high, before[1])


@inlined
def lane_hash(halves: Any, lane: int) -> Any:
    """Returns the hash of one lane, as uint64."""
    return scrambled((word_of(halves[1], lane) << HALF_WORD) | word_of(halves[0], lane))
