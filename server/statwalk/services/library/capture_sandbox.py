"""Reads the captures of a machine in the data folder in a child process with bounded memory and time, as
`upload_sandbox` reads models.

The child (`python -m statwalk.services.library.capture_sandbox CHARACTER TEXT FOLDER OUT`) writes the checked
character with the captured motions as clips. The server keeps it beside the machine file, under a hash of
what it was made of, and loads it from then on.
"""

from __future__ import annotations

import hashlib
import sys
from contextlib import suppress
from pathlib import Path

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.character_archive import read_character, write_character
from statwalk.files.machine_yaml.capture_lines import with_captures
from statwalk.files.machine_yaml.machine_file import MachineFile, machine_of
from statwalk.services.cancel import NEVER, CancelToken
from statwalk.services.library.upload_sandbox import (
    WALL_SECONDS,
    answer_as_child,
    checked_beside,
    child_answer,
)

KEPT = ".captured-{}.npz"


def captured(
    character: Character, file: MachineFile, folder: Path, working: Path, token: CancelToken = NEVER
) -> Character:
    """Returns a character with the captured motions that a machine file in `folder` names; a child makes it
    in the folder `working`, if it is not kept yet.

    :raises ContentError: when a capture is refused, or the child exceeds its memory or time.
    :raises StorageError: when the disk refuses what the child writes.
    :raises CancelledError: when the token is cancelled; the child is killed.
    """
    kept = folder / KEPT.format(_digest(character, file, folder))
    with suppress(ContentError):
        return read_character(kept, character.model_glb)
    out, text, bare = working / "captured.glb", working / "text", working / "bare.npz"
    text.write_text(file.text, encoding="utf-8", newline="")
    write_character(character, bare)
    arguments = [str(path.resolve()) for path in (bare, text, folder, out)]
    child_answer("statwalk.services.library.capture_sandbox", arguments, working, token, WALL_SECONDS)
    for old in folder.glob(KEPT.format("*")):
        old.unlink(missing_ok=True)
    checked_beside(out).replace(kept)
    return read_character(kept, character.model_glb)


def _digest(character: Character, file: MachineFile, folder: Path) -> str:
    """A hash of what a character with captured motions is made of."""
    digest = hashlib.sha256(character.model_glb)
    for line in file.captures:
        path = folder / line.path
        digest.update(repr((line.path, line.how, line.wish)).encode())
        digest.update(hashlib.sha256(path.read_bytes() if path.is_file() else b"").digest())
    return digest.hexdigest()


def main(bare: str, text: str, folder: str, out: str) -> None:
    """Runs the child."""
    answer_as_child(lambda: _read(Path(bare), Path(text), Path(folder)), Path(out))


def _read(bare: Path, text: Path, folder: Path) -> Character:
    file = machine_of(text.read_bytes().decode(), folder)
    return with_captures(read_character(bare, b""), file.captures, folder)


if __name__ == "__main__":
    main(*sys.argv[1:])
