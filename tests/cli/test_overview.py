"""The command without a verb is quick, and what it needs is said in one sentence."""

import os
import subprocess
import sys

import pytest
import statwalk

MISSING = """
import sys
class Missing:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] == "numba":
            raise ModuleNotFoundError("No module named 'numba'", name="numba")
sys.meta_path.insert(0, Missing())
"""
COMMAND = """
import sys
sys.argv = ["statwalk", *sys.argv[1:]]
from statwalk.cli import main
main()
"""
PREPARE = "import runpy; runpy.run_module('statwalk.maths.prepare', run_name='__main__')"
LOAD = """
import statwalk
try:
    statwalk.load("faq-walker")
except statwalk.StatwalkError as error:
    print(error)
"""
NO_NUMBA = (
    "numba, which compiles the inner loops of statwalk, can't be imported here: No module named 'numba'. "
    "Install it: python -m pip install numba"
)
SWITCHED_OFF = (
    "poses need compiled code, and the compiler is switched off here: unset STATWALK_COMPILED and "
    "NUMBA_DISABLE_JIT"
)
ENVIRONMENT = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path)), "COLUMNS": "200"}


def run(code, *arguments, **variables):
    return subprocess.run(
        [sys.executable, "-c", code, *arguments],
        capture_output=True,
        text=True,
        env=ENVIRONMENT | variables,
        timeout=60,
    )


def test_the_overview_needs_no_compiler_and_no_arrays():
    code = (
        "import sys; from statwalk.cli import main; sys.argv = ['statwalk', '--help']\ntry: main()\n"
        "finally: print(*sys.modules)"
    )
    printed = run(code).stdout
    assert "Serves the API and the viewer" in printed
    assert not {"numba", "numpy", "fastapi", "statwalk.stage.stage"} & set(printed.split())


@pytest.mark.parametrize("verb", ["serve", "measure"])
def test_help_compiles_nothing(verb, tmp_path):
    ended = run(COMMAND, verb, "--help", STATWALK_CACHE=str(tmp_path))
    assert "Examples:" in ended.stdout
    assert (ended.stderr, list(tmp_path.iterdir())) == ("", [])


def test_without_numba_a_verb_ends_with_a_sentence():
    for verb in ("serve", "play", "verify"):
        ended = run(MISSING + COMMAND, verb)
        assert (ended.returncode, ended.stderr) == (2, f"statwalk: {NO_NUMBA}\n")


def test_without_numba_preparing_ends_with_the_same_sentence():
    ended = run(MISSING + PREPARE)
    assert (ended.returncode, ended.stderr) == (2, f"statwalk: {NO_NUMBA}\n")


def test_without_numba_python_gets_an_error_of_ours():
    assert run(MISSING + LOAD).stdout == f"{NO_NUMBA}\n"


@pytest.mark.parametrize("variables", [{"STATWALK_COMPILED": "0"}, {"NUMBA_DISABLE_JIT": "1"}])
def test_where_the_compiler_is_switched_off_a_verb_ends_with_a_sentence(variables):
    for arguments in (("serve", "--port", "0"), ("play", "faq-walker"), ("verify", "faq-walker")):
        ended = run(COMMAND, *arguments, **variables)
        assert (ended.returncode, ended.stderr) == (2, f"statwalk: {SWITCHED_OFF}\n")


def test_where_the_compiler_is_switched_off_python_gets_an_error_of_ours():
    assert run(LOAD, STATWALK_COMPILED="0").stdout == f"{SWITCHED_OFF}\n"


def test_every_name_of_the_face_is_there():
    assert all(getattr(statwalk, name).__name__ == name for name in statwalk.__all__)


def test_python_m_statwalk_is_the_command():
    ran = subprocess.run(
        [sys.executable, "-m", "statwalk", "play", "nobody"], env=ENVIRONMENT, capture_output=True, text=True
    )
    assert (ran.returncode, "'nobody'" in ran.stderr) == (2, True)
