"""What the documents say is true: every example runs on what is here, every file and link they name is
there.
"""

import argparse
import re
import shlex
import subprocess
from collections.abc import Iterator
from pathlib import Path

import captures
import httpx
import pytest
import tiny_model
from command_line import statwalk
from paths import ROOT
from serving import PATIENCE, serving, wait_for
from statwalk.web.app import create_app

DOCUMENTS = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]
PYTHON = re.compile(r"^```python\n(.*?)^```", re.MULTILINE | re.DOTALL)
BLOCK = re.compile(r"^```(python|sh)\n(.*?)^```", re.MULTILINE | re.DOTALL)
SEEN_ELSEWHERE = ("python3 server", ". .venv/bin/activate", "statwalk serve")
"""what sets up, and what runs until it is stopped: tests/web/test_serve.py starts it"""
LINK = re.compile(r"\]\((?!https?://|#)([^)#]+)")
WITH_EXAMPLES = [
    path for path in DOCUMENTS[1:] if PYTHON.search(path.read_text())
]  # the README has a test of its own


@pytest.mark.parametrize("document", WITH_EXAMPLES, ids=lambda path: path.name)
def test_examples_run(document: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The Python blocks of one document run in order, in one namespace, beside a robot and a capture of one's
    own.
    """
    walker = ROOT / "machines" / "faq-walker" / "walker.glb"  # has legs, which a captured motion needs
    robot = walker.read_bytes() if document.name == "capture.md" else tiny_model.robot()
    (tmp_path / "robot.glb").write_bytes(robot)
    (tmp_path / "walk.bvh").write_text(captures.walk())
    monkeypatch.chdir(tmp_path)
    namespace: dict[str, object] = {"__name__": "example"}
    for block in PYTHON.findall(document.read_text()):
        exec(compile(block, str(document), "exec"), namespace)  # our own documents


@pytest.fixture
def address() -> Iterator[str]:
    """A server that has run for a moment, as a reader's will have."""
    with (
        serving(create_app()) as address,
        httpx.Client(base_url=f"http://{address}", timeout=PATIENCE) as rest,
    ):
        wait_for(lambda: rest.get("/api/stages/main").json()["tick"] > 10)
        yield address


def curl(arguments: list[str], address: str, folder: Path) -> None:
    """What curl would do, with the server's own address; an answer that is no success is an error."""
    known = argparse.ArgumentParser()
    known.add_argument("url")
    known.add_argument("-s", action="store_true")
    known.add_argument("-H", action="append", default=[])
    known.add_argument("-d")
    known.add_argument("-o")
    asked = known.parse_args(arguments)
    headers = dict(line.split(": ") for line in asked.H)
    url = "http://" + asked.url.replace("localhost:8000", address)
    answer = httpx.request(
        "POST" if asked.d else "GET", url, content=asked.d, headers=headers, timeout=100
    ).raise_for_status()
    if asked.o:
        (folder / asked.o).write_bytes(answer.content)


def shell(line: str, address: str, folder: Path) -> None:
    """A line of a shell, its comment left out."""
    program, *arguments = shlex.split(line, comments=True)
    if program == "curl":
        curl(arguments, address, folder)
    elif program == "statwalk":
        ended = statwalk(*arguments, cwd=folder)
        assert ended.returncode == 0, ended.stderr
    else:
        subprocess.run([program, *arguments], cwd=folder, check=True, capture_output=True, timeout=200)


def test_the_whole_readme_runs_as_printed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, address: str
) -> None:
    """All blocks in order, in a folder with nothing but the machines that ship."""
    (tmp_path / "machines").symlink_to(ROOT / "machines")
    monkeypatch.chdir(tmp_path)
    namespace: dict[str, object] = {"__name__": "example"}
    for kind, block in BLOCK.findall((ROOT / "README.md").read_text()):
        if kind == "python":
            exec(compile(block, "README.md", "exec"), namespace)  # our own document
            continue
        for line in block.splitlines():
            if not line.startswith(SEEN_ELSEWHERE):
                shell(line, address, tmp_path)
    assert {path.name for path in tmp_path.iterdir()} == {
        "machines",
        "posed.glb",
        "robot.glb",
        "my-robot",
        "pose.npz",
    }


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: path.name)
def test_links_lead_somewhere(document: Path) -> None:
    for target in LINK.findall(document.read_text()):
        assert (document.parent / target).exists(), f"{document.name} names {target}"


def test_every_picture_is_shown_and_small() -> None:
    """What lies in docs/pictures is named by a document, and is quickly there over a slow line."""
    named = {
        (path.parent / target).resolve() for path in DOCUMENTS for target in LINK.findall(path.read_text())
    }
    pictures = list((ROOT / "docs" / "pictures").iterdir())
    assert [path.name for path in pictures if path.resolve() not in named] == []
    assert {path.name: path.stat().st_size for path in pictures if path.stat().st_size > 400_000} == {}


@pytest.mark.parametrize(
    "document", [ROOT / "docs" / "systems.md", ROOT / "CONTRIBUTING.md"], ids=lambda path: path.name
)
def test_files_that_are_named_are_there(document: Path) -> None:
    """`machine/ticking/step.py` in the text is server/statwalk/machine/ticking/step.py; other paths count
    from the root.
    """
    for name in re.findall(r"`([\w.-]+(?:/[\w.-]+)+)/?`", document.read_text()):
        assert any((base / name).exists() for base in (ROOT, ROOT / "server" / "statwalk")), (
            f"{document.name} names {name}"
        )
