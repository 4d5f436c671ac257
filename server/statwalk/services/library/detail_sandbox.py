"""Finds the level of detail of an uploaded character in a child process with bounded memory and time, as
`upload_sandbox` reads it.

The child (`python -m statwalk.services.library.detail_sandbox MODEL OUT NAME`) writes the model with its
order as a .glb, and the checked character beside it.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

from statwalk.files.gltf import read_model
from statwalk.files.gltf.detailed_model import with_detail
from statwalk.services.cancel import NEVER, CancelToken
from statwalk.services.library.upload_sandbox import answer_as_child, child_answer

PROCESSOR_SECONDS = 120
WALL_SECONDS = 240


def detail_in_child(model: Path, out: Path, name: str, token: CancelToken = NEVER) -> dict[str, Any]:
    """Has a child find the order of a .glb, and write `out` and the checked character beside it; returns
    facts about the character.

    :raises ContentError: when the model has no triangles or too many, or the child exceeds its memory or
        time.
    :raises CancelledError: when the token is cancelled; the child is killed.
    """
    arguments = [str(model), str(out), name]
    module = "statwalk.services.library.detail_sandbox"
    return child_answer(module, arguments, out.parent, token, WALL_SECONDS)


def main(model: str, out: str, name: str) -> None:
    """Runs the child."""
    answer_as_child(
        lambda: with_detail(read_model(Path(model).read_bytes(), name)), Path(out), PROCESSOR_SECONDS
    )


if __name__ == "__main__":
    main(*sys.argv[1:])
