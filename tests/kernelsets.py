"""Both sets of inner loops, compiled and NumPy, for tests that must hold with either."""

import pytest
from statwalk.maths.kernels import choose


@pytest.fixture(params=["numba", "numpy"])
def kernel_set(request, monkeypatch):
    """Runs the test once with each."""
    monkeypatch.setenv(choose.VARIABLE, request.param)
    choose.kernels.cache_clear()
    yield request.param
    choose.kernels.cache_clear()
