"""The viewer's types are strict, its generated types are those of the server, and the tests beside its
sources pass.
"""

import json
import os
import shlex
import shutil
import subprocess
from pathlib import Path
from typing import Any

import playwright
import pytest
from paths import ROOT
from statwalk.web.app import openapi_document

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
    """The viewer's node_modules, installed if one is missing."""
    folder = VIEWER / "node_modules"
    package = json.loads((VIEWER / "package.json").read_text())
    if not all((folder / name).is_dir() for name in package["dependencies"] | package["devDependencies"]):
        npm = shutil.which("npm")
        assert npm, "static/node_modules is missing and there is no npm to install it"
        subprocess.run([npm, "ci", "--no-audit", "--no-fund"], cwd=VIEWER, check=True, capture_output=True)
    return folder


def run(*command: str | Path, hint: str = "", **options: Any) -> str:
    """What a script of the viewer's printed; fails with it, and what to do then, where it failed."""
    environment = {**os.environ, "NO_COLOR": "1"}
    done = subprocess.run(
        [node(), *command],
        cwd=VIEWER,
        capture_output=True,
        text=True,
        env=environment,
        check=False,
        **options,
    )
    assert done.returncode == 0, done.stdout + done.stderr + hint
    return done.stdout


def test_types_are_right(modules: Path) -> None:
    run(modules / "typescript" / "bin" / "tsc", "--noEmit")


def test_sources_have_no_lint(modules: Path) -> None:
    _, *arguments = json.loads((VIEWER / "package.json").read_text())["scripts"]["lint"].split()
    run(modules / "eslint" / "bin" / "eslint.js", *arguments)


def test_sources_are_formatted(modules: Path) -> None:
    _, *arguments = json.loads((VIEWER / "package.json").read_text())["scripts"]["format"].split()
    run(
        modules / "prettier" / "bin" / "prettier.cjs", *arguments, "--check", hint="npm run format -- --write"
    )


def test_the_types_of_the_server_are_not_stale(modules: Path) -> None:
    script = json.loads((VIEWER / "package.json").read_text())["scripts"]["types"]
    _, *arguments = shlex.split(script.partition("|")[2])
    tool = modules / "openapi-typescript" / "bin" / "cli.js"
    run(
        tool,
        *arguments,
        "--check",
        input=json.dumps(openapi_document()),
        hint="`npm run types` in static/ writes them again",
    )


def test_units_pass(modules: Path) -> None:
    assert "passed" in run(modules / "vitest" / "vitest.mjs", "run")
