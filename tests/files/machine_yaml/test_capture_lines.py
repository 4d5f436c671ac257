"""`captures` of a machine file: files in its folder become clips; wrong ones are refused with the line."""

from pathlib import Path

import captures
import pytest
from statwalk.character.role import Role
from statwalk.errors import MachineError
from statwalk.services.library.load import load

TEXT = """character: faq-walker
root: Root
captures:
  stroll: {CAPTURE}
initial: A
states: {A: {motion: stroll, loop: true}}
table: |
  state | GO
  A     | A
"""


def role_of(folder: Path, capture: str) -> Role:
    (folder / "walk.bvh").write_text(captures.walk())
    (folder / "machine.yaml").write_text(TEXT.replace("CAPTURE", capture))
    role = load(folder)
    assert isinstance(role, Role)
    return role


def test_a_captured_walk_is_a_motion_that_travels(tmp_path: Path) -> None:
    role = role_of(
        tmp_path, "file: walk.bvh, start: 0.2, end: 0.8, loop: true, filter: {low_pass: 6, spikes: true}"
    )
    clip = role.character.clips["stroll"]
    assert clip.duration == pytest.approx(0.6, abs=0.04)
    assert clip.loop
    assert role.travels


@pytest.mark.parametrize(
    ("capture", "said"),
    [
        ("file: ../walk.bvh", "line 4: .*must name a .bvh or .trc file in the folder"),
        ("file: /etc/passwd", "must name"),
        ("loop: true", "needs a file"),
        ("file: none.bvh", "line 4: capture stroll: .*there is no such file"),
        ("file: walk.bvh, position: left", "no position is called 'left'"),
        ("file: walk.bvh, filter: {low_pass: -1}", "-1"),
        ("file: walk.bvh, bones: {Tail: x}", "no bone is called 'Tail'"),
        ("file: walk.bvh, bones: {Hips: x}", "no joint is called 'x'"),
        ("file: walk.bvh, start: 9", "lasts 1 s"),
        ("file: walk.bvh, sped: 9", "no key is called 'sped'"),
    ],
)
def test_wrong_lines_are_refused(tmp_path: Path, capture: str, said: str) -> None:
    with pytest.raises(MachineError, match=said):
        role_of(tmp_path, capture)
