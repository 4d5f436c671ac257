"""Kernels keep the rules of IEEE arithmetic, and can stay plain Python."""

import os
import subprocess
import sys

import numpy as np
import pytest
from statwalk.errors import StatwalkError
from statwalk.maths import compiling, reference

SOURCE = "def double(numbers):\n    for row in range(numbers.shape[0]):\n        numbers[row] *= 2\n"
PLAIN = """
import numpy as np
from statwalk.rig import _kernels, hierarchy
out = np.zeros((1, 1, 3, 4), np.float32)
shapes = (1, 1, 3), (1, 1, 4), (1, 1, 3)
_kernels.world(np.array([-1], np.int32), *(np.ones(shape, np.float32) for shape in shapes), out)
print(type(_kernels.world).__name__, type(hierarchy.local_rows).__name__, out.tolist())
"""

COUNTED = """
from statwalk.maths import compiling
with compiling.announced(lambda number, name: print(name)):
    from statwalk.motion.keys import _kernels
"""


def made(source, name):
    place = {}
    exec(source, place)
    return place[name]


def test_a_kernel_without_a_file_works():
    numbers = np.array([1, 2], np.float32)
    compiling.kernel(compiling.write(compiling.FLOAT, 1))(made(SOURCE, "double"))(numbers)
    assert numbers.tolist() == [2, 4]


def test_sums_of_products_are_not_fused_behind_ones_back():
    product = made("def product(a, out):\n    out[0] = a[0] * a[1] + a[2]\n", "product")
    a = np.array([1 + 2**-12, 1 + 2**-12, -1 - 2**-11], np.float32)
    out = np.empty(1, np.float32)
    compiling.kernel(compiling.read(compiling.FLOAT, 1), compiling.write(compiling.FLOAT, 1))(product)(a, out)
    assert out[0] == 0  # the product is rounded before the sum; fused it would be 2**-24


def told(compiled):
    environment = {
        **os.environ,
        "PYTHONPATH": os.pathsep.join(filter(None, sys.path)),
        "STATWALK_COMPILED": compiled,
    }
    return subprocess.run(
        [sys.executable, "-c", PLAIN], env=environment, capture_output=True, text=True, check=True
    ).stdout.split(" ", 2)


def test_one_switch_leaves_kernels_and_what_they_call_plain_python():
    kinds_plain, kinds_compiled = told("0"), told("1")
    assert kinds_plain[:2] == ["function", "function"]
    assert "function" not in kinds_compiled[:2]
    assert kinds_plain[2] == kinds_compiled[2]


def test_a_part_of_kernels_is_not_called_from_python():
    part = compiling.inlined(made("def twice(x):\n    return x + x\n", "twice"))
    with pytest.raises(StatwalkError, match="twice is a part of kernels"):
        part(1)


def test_a_called_part_is_not_inlined_though_its_caller_is():
    place = {"numbers": None}
    exec("def inner(x):\n    return x + 1.0\ndef outer(x):\n    return inner(x)\n", place)
    place["inner"], place["outer"] = reference.called(place["inner"]), compiling.inlined(place["outer"])
    exec("def run(a):\n    a[0] = outer(a[0])\n", place)
    kernel = compiling.kernel(compiling.write(compiling.FLOAT, 1))(place["run"])
    text = kernel.inspect_llvm(kernel.signatures[0])
    defined = [line for line in text.splitlines() if line.startswith("define")]
    assert [any(name in line for line in defined) for name in ("5inner", "5outer")] == [True, False]


def test_two_processes_compile_a_kernel_once(tmp_path):
    environment = {
        **os.environ,
        "PYTHONPATH": os.pathsep.join(filter(None, sys.path)),
        "STATWALK_CACHE": str(tmp_path),
    }
    processes = [
        subprocess.Popen([sys.executable, "-c", COUNTED], env=environment, stdout=subprocess.PIPE, text=True)
        for _ in range(2)
    ]
    compiled = "".join(process.communicate()[0] for process in processes).split()
    assert sorted(compiled) == ["constant", "gathered", "lines", "turns"]
