"""Kernels give the same bits whatever processor they are compiled for, and however much they are optimised: a
replay on an older machine shows the same poses.

R-05's script (`python benchmarks/reliability.py replay`) compiles for other processors with all optimisation,
which takes longer.
"""

import json
import os
import subprocess
import sys

import pytest
from kernel_digests import of_the_product
from statwalk.maths.prepare import prepare

DIGESTS = (
    "from statwalk.maths.prepare import prepare; prepare(alone=True); import kernel_digests; "
    "kernel_digests.main()"
)
PLAIN = {
    # no registers of 512 bits, and no FMA: `fused` is a call; empty, or numba adds the host's features
    "NUMBA_CPU_NAME": "generic",
    "NUMBA_CPU_FEATURES": "",
    "NUMBA_OPT": "0",  # no vectors, and nothing in another order
    "PYTHONWARNINGS": "ignore:Cannot cache",  # without optimisation a kernel keeps addresses of this process
}
pytestmark = pytest.mark.timeout(600)


def on(**variables):
    """What `kernel_digests` prints when everything is compiled for the target that the variables name, and
    what is said meanwhile.
    """
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path)), **variables}
    ended = subprocess.run(
        [sys.executable, "-c", DIGESTS], env=environment, capture_output=True, text=True, check=True
    )
    return json.loads(ended.stdout) | {"says": ended.stderr}


@pytest.fixture(scope="module")
def digests(tmp_path_factory):
    """What two processors print: this one, and a plain one that everything is compiled for now."""
    # a folder of its own: only code that was compiled now can be looked into
    plain = PLAIN | {"STATWALK_CACHE": str(tmp_path_factory.mktemp("plain"))}
    return {"here": on(), "plain": on(**plain)}


def test_a_processor_without_fma_and_512_bit_registers_gives_the_same_bits(digests):
    assert digests["plain"]["digests"] == digests["here"]["digests"]


def test_everything_was_compiled_for_it(digests):
    plain = digests["plain"]
    assert (sorted(plain["compiled"]), plain["newer"]) == (sorted(names()), [])
    assert plain["says"] == (
        f"statwalk: compiling {len(names())} kernels, once for this version and processor …\n"
    )


def names():
    prepare()
    return [made.__name__ for made in of_the_product()]
