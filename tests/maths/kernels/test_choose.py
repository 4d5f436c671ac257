import subprocess
import sys

import pytest
from statwalk.maths.kernels import choose


@pytest.fixture(autouse=True)
def anew():
    """A choice of its own for every test."""
    choose.kernels.cache_clear()
    yield
    choose.kernels.cache_clear()


def test_compiled_kernels_are_the_rule(monkeypatch):
    monkeypatch.delenv(choose.VARIABLE, raising=False)
    assert choose.kernels() is not None


def test_numpy_can_be_asked_for(monkeypatch):
    monkeypatch.setenv(choose.VARIABLE, "numpy")
    assert choose.kernels() is None


def test_without_numba_numpy_does_the_work(monkeypatch):
    monkeypatch.delenv(choose.VARIABLE, raising=False)
    for name in [name for name in sys.modules if name.startswith("statwalk.maths.kernels.") and name != choose.__name__]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "numba", None)
    assert choose.kernels() is None


def test_nothing_is_compiled_before_it_is_wanted():
    code = "import statwalk, statwalk.web.app, sys; print('numba' in sys.modules or 'llvmlite' in sys.modules)"
    said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert said.stdout.strip() == "False"


def test_a_numba_that_is_broken_is_reported_and_done_without(monkeypatch, caplog):
    def broken(name):
        raise RuntimeError("no LLVM")

    monkeypatch.delenv(choose.VARIABLE, raising=False)
    monkeypatch.setattr(choose, "import_module", broken)
    assert choose.kernels() is None
    assert "no LLVM" in caplog.text
