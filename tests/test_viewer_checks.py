"""The viewer's types are strict, its generated types are those of the server, the tests beside its sources
pass, and the page begins with few bytes.
"""

import gzip
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
MOST_KB = 350
"""the first load of the page, compressed"""


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


def first_load(build: Path) -> dict[str, bytes]:
    """The files that the page loads before you click: what index.html names, and what that imports."""
    chunks = json.loads((build / ".vite" / "manifest.json").read_text())
    wanted, names = ["index.html"], {"index.html"}
    while wanted:
        chunk = chunks[wanted.pop()]
        names |= {chunk["file"], *chunk.get("css", []), *chunk.get("assets", [])}
        wanted += chunk.get("imports", [])
    return {name: (build / name).read_bytes() for name in names}


def test_the_page_begins_with_few_bytes_without_plots_and_without_an_editor(
    modules: Path, tmp_path: Path
) -> None:
    run(
        modules / "vite" / "bin" / "vite.js",
        "build",
        "--manifest",
        "--outDir",
        tmp_path,
        "--logLevel",
        "warn",
    )
    loaded = first_load(tmp_path)
    assert sum(len(gzip.compress(data)) for data in loaded.values()) <= 1000 * MOST_KB
    for later in ("uPlot", "yamlEditor"):
        names = {path.relative_to(tmp_path).as_posix() for path in tmp_path.glob(f"assets/{later}*")}
        assert names
        assert not names & set(loaded)
