"""The kernels give the same bits whatever instructions NumPy may use: a replay on an older CPU shows the same
poses.
"""

import hashlib
import os
import subprocess
import sys

import numpy as np
import pytest
from numpy._core._multiarray_umath import __cpu_dispatch__, __cpu_features__
from statwalk.maths import elementary, quat, transform

DISPATCHED = [feature for feature in __cpu_dispatch__ if __cpu_features__.get(feature)]


def digest() -> str:
    """A hash over every kernel of the tick, for a crowd of odd size."""
    rng = np.random.default_rng(29)
    result = hashlib.sha256()
    for dtype in (np.float32, np.float64):
        a, b = (quat.normalize(rng.normal(size=(1003, 4)).astype(dtype)) for _ in range(2))
        f, v = rng.uniform(size=1003).astype(dtype), rng.normal(size=(1003, 3)).astype(dtype)
        trs = transform.from_trs(v, a, np.abs(v))
        kernels = [
            quat.mul(a, b),
            quat.slerp(a, b, f),
            quat.nlerp(a, b, f),
            quat.from_rotation_vector(v),
            quat.to_rotation_vector(a),
        ]
        kernels += [
            quat.rotate(a, v),
            trs,
            transform.mul(trs, trs[::-1]),
            quat.from_euler_xyz(v),
            quat.to_euler_xyz(a),
            elementary.exp(v),
        ]
        for kernel in kernels:
            result.update(np.ascontiguousarray(kernel).tobytes())
    return result.hexdigest()


@pytest.mark.skipif(not DISPATCHED, reason="NumPy has no other instructions to choose from on this machine")
def test_without_the_cpus_newer_instructions():
    command = [sys.executable, "-c", "from maths.test_same_bits_everywhere import digest; print(digest())"]
    path = os.pathsep.join(filter(None, sys.path))
    environment = {**os.environ, "NPY_DISABLE_CPU_FEATURES": " ".join(DISPATCHED), "PYTHONPATH": path}
    plain = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    assert plain.stdout.strip() == digest()
