"""Kernels give the same bits whatever processor they are compiled for: a replay on an older machine shows the
same poses.
"""

import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import pytest
from kernel_digests import of_the_product
from statwalk.maths.prepare import prepare

HASWELL = {"NUMBA_CPU_NAME": "haswell", "NUMBA_CPU_FEATURES": ""}  # empty, or numba adds the host's features
DIGESTS = (
    "from statwalk.maths.prepare import prepare; prepare(alone=True); import kernel_digests; "
    "kernel_digests.main()"
)
GENERIC = {"NUMBA_CPU_NAME": "generic"}  # no FMA: `fused` is a call
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
    """What three processors print, by name; they are compiled for at the same time."""
    # a folder of its own: only code that was compiled now can be looked into
    haswell = HASWELL | {"STATWALK_CACHE": str(tmp_path_factory.mktemp("haswell"))}
    with ThreadPoolExecutor() as pool:
        runs = {
            "here": pool.submit(on),
            "haswell": pool.submit(on, **haswell),
            "generic": pool.submit(on, **GENERIC),
        }
        return {name: run.result() for name, run in runs.items()}


def test_a_processor_without_512_bit_registers_gives_the_same_bits(digests):
    haswell = digests["haswell"]
    assert haswell["digests"] == digests["here"]["digests"]
    assert (sorted(haswell["compiled"]), haswell["wide"]) == (sorted(names()), [])
    assert haswell["says"] == (
        f"statwalk: compiling {len(names())} kernels, once for this version and processor …\n"
    )


def test_a_processor_without_fma_gives_the_same_bits(digests):
    assert digests["generic"]["digests"] == digests["here"]["digests"]


def names():
    prepare()
    return [made.__name__ for made in of_the_product()]
