"""The stack of kernels begins at a multiple of 64 bytes: what they keep there lies in one cache line."""

import re

from statwalk.maths import compiling
from statwalk.maths.simd.lanes import LANES, load, store

KEPT = 40
"""more lanes than any processor has registers"""
LOADS = [f"    lanes{i} = load(values, {LANES * i})" for i in range(KEPT)]
STORES = [f"    store(out, {LANES * i}, lanes{KEPT - 1 - i})" for i in range(KEPT)]
SOURCE = "\n".join(["def turned(values, out):", *LOADS, *STORES])
"""`out` may be `values`, so that all is loaded before anything is stored"""


def test_lanes_on_the_stack_are_aligned():
    place = {"load": load, "store": store}
    exec(SOURCE, place)
    numbers = compiling.write(compiling.FLOAT, 1)
    (code,) = compiling.kernel(numbers, numbers)(place["turned"]).inspect_asm().values()
    kernel, _wrappers_for_python = code.split("_ZN7cpython", 1)
    kept = set(re.findall(r"vmov([au])ps\t%[yz]mm\d+, \d*\(%rsp\)", kernel))
    assert kept == {"a"}
