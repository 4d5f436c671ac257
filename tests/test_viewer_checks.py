"""The viewer's own checks: strict types, and the tests beside its sources."""

import os
import shutil
import subprocess
from pathlib import Path

import playwright
import pytest
from where import ROOT

VIEWER = ROOT / "static"


def node() -> Path:
    """Node from PATH, else the one that Playwright brings along."""
    found = shutil.which("node")
    if found:
        return Path(found)
    bundled = Path(playwright.__file__).parent / "driver" / "node"
    assert bundled.is_file(), "there is no node: install Node 20.19 or newer"
    return bundled


@pytest.fixture(scope="session")
def modules() -> Path:
    """The viewer's node_modules, installed if they are missing."""
    folder = VIEWER / "node_modules"
    if not (folder / ".bin").is_dir():
        npm = shutil.which("npm")
        assert npm, "static/node_modules is missing and there is no npm to install it"
        subprocess.run([npm, "ci", "--no-audit", "--no-fund"], cwd=VIEWER, check=True, capture_output=True)
    return folder


def run(*command: str | Path) -> str:
    """What a script of the viewer's printed; fails with it where it failed."""
    environment = {**os.environ, "NO_COLOR": "1"}
    done = subprocess.run([node(), *command], cwd=VIEWER, capture_output=True, text=True, env=environment, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_types_are_right(modules: Path) -> None:
    run(modules / "typescript" / "bin" / "tsc", "--noEmit")


def test_units_pass(modules: Path) -> None:
    assert "passed" in run(modules / "vitest" / "vitest.mjs", "run")
