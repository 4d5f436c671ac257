"""The captures of a machine in the data folder are read by a child process, once."""

from pathlib import Path

import captures
import numpy as np
import pytest
from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.machine_yaml.machine_file import FILE_NAME, load_machine
from statwalk.services.library import capture_sandbox
from statwalk.services.library.capture_sandbox import captured
from statwalk.services.library.load import character_from

TEXT = """character: faq-walker
root: Root
captures: {stroll: {file: walk.bvh, start: START}}
initial: A
states: {A: {motion: stroll, loop: true}}
table: |
  state | GO
  A     | A
"""


@pytest.fixture(scope="module")
def walker() -> Character:
    return character_from("faq-walker")


def read(folder: Path, walker: Character, start: str = "0.2") -> Character:
    (folder / "walk.bvh").write_text(captures.walk())
    (folder / FILE_NAME).write_text(TEXT.replace("START", start))
    working = folder / "working"
    working.mkdir(exist_ok=True)
    return captured(walker, load_machine(folder), folder, working)


def test_it_is_the_clip_that_the_server_would_read(tmp_path: Path, walker: Character) -> None:
    clip, own = read(tmp_path, walker).clips["stroll"], character_from(tmp_path).clips["stroll"]
    assert clip.duration == own.duration
    for time in np.linspace(0, own.duration, 7):
        np.testing.assert_array_equal(clip.sample(time).rotation, own.sample(time).rotation)


def test_it_is_read_once(tmp_path: Path, walker: Character, monkeypatch: pytest.MonkeyPatch) -> None:
    first = read(tmp_path, walker)
    monkeypatch.setattr(capture_sandbox, "child_answer", None)
    assert read(tmp_path, walker).clips["stroll"].duration == first.clips["stroll"].duration
    with pytest.raises(TypeError):  # the control: another line is read again
        read(tmp_path, walker, "0.4")


def test_a_wrong_capture_is_refused_with_its_line(tmp_path: Path, walker: Character) -> None:
    with pytest.raises(ContentError, match=r"line 3: capture stroll: .*lasts 1 s"):
        read(tmp_path, walker, "9")
