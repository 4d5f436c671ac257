"""Kernels give the same bits whatever processor they are compiled for: a replay on an older machine shows the
same poses.
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
# no registers of 512 bits, and no FMA: `fused` is a call; empty, or numba adds the host's features
GENERIC = {"NUMBA_CPU_NAME": "generic", "NUMBA_CPU_FEATURES": ""}
pytestmark = pytest.mark.timeout(900)  # 7 minutes on an EPYC of the third generation, beside other tests


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
    """What two processors print: this one, and one that everything is compiled for now."""
    # a folder of its own: only code that was compiled now can be looked into
    generic = GENERIC | {"STATWALK_CACHE": str(tmp_path_factory.mktemp("generic"))}
    return {"here": on(), "generic": on(**generic)}


def test_a_processor_without_fma_and_512_bit_registers_gives_the_same_bits(digests):
    assert digests["generic"]["digests"] == digests["here"]["digests"]


def test_everything_was_compiled_for_it_and_uses_no_wide_registers(digests):
    generic = digests["generic"]
    assert (sorted(generic["compiled"]), generic["newer"]) == (sorted(names()), [])
    assert generic["says"] == (
        f"statwalk: compiling {len(names())} kernels, once for this version and processor …\n"
    )


def names():
    prepare()
    return [made.__name__ for made in of_the_product()]
