"""What the documents say is true: every Python example runs, every file and link they name is there."""

import re
import shutil
from pathlib import Path

import pytest
from where import GLTF, ROOT, needs_assets

DOCUMENTS = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]
PYTHON = re.compile(r"^```python\n(.*?)^```", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\((?!https?://|#)([^)#]+)")
WITH_EXAMPLES = [path for path in DOCUMENTS if PYTHON.search(path.read_text())]


@needs_assets
@pytest.mark.parametrize("document", WITH_EXAMPLES, ids=lambda path: path.name)
def test_examples_run(document: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The blocks of one document run in order, in one namespace, beside the models they name."""
    shutil.copy(GLTF / "Khronos_Fox.glb", tmp_path / "fox.glb")
    shutil.copy(GLTF / "RobotExpressive.glb", tmp_path / "robot.glb")
    monkeypatch.chdir(tmp_path)
    namespace: dict[str, object] = {"__name__": "example"}
    for block in PYTHON.findall(document.read_text()):
        exec(compile(block, str(document), "exec"), namespace)  # our own documents


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: path.name)
def test_links_lead_somewhere(document: Path) -> None:
    for target in LINK.findall(document.read_text()):
        assert (document.parent / target).exists(), f"{document.name} names {target}"


def test_every_picture_is_shown_and_small() -> None:
    """What lies in docs/pictures is named by a document, and is quickly there over a slow line."""
    named = {(path.parent / target).resolve() for path in DOCUMENTS for target in LINK.findall(path.read_text())}
    pictures = list((ROOT / "docs" / "pictures").iterdir())
    assert [path.name for path in pictures if path.resolve() not in named] == []
    assert {path.name: path.stat().st_size for path in pictures if path.stat().st_size > 400_000} == {}


@pytest.mark.parametrize("document", [ROOT / "docs" / "systems.md", ROOT / "CONTRIBUTING.md"], ids=lambda path: path.name)
def test_files_that_are_named_are_there(document: Path) -> None:
    """`machine/ticking/step.py` in the text is server/statwalk/machine/ticking/step.py; other paths count from the root."""
    for name in re.findall(r"`([\w.-]+(?:/[\w.-]+)+)/?`", document.read_text()):
        assert any((base / name).exists() for base in (ROOT, ROOT / "server" / "statwalk")), f"{document.name} names {name}"
