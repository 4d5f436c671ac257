"""Rigs an uploaded character in a child process with bounded memory and time, as `upload_sandbox` reads it.

The child (`python -m statwalk.services.library.rig_sandbox MODEL OUT NAME WISH`) writes the rigged model as a
.glb, and the checked character beside it.
"""

from __future__ import annotations

import json
import sys
from dataclasses import asdict
from pathlib import Path
from typing import Any

from statwalk.character.autorig.wish import RigWish
from statwalk.files.gltf import read_model
from statwalk.files.gltf.rigged import rigged
from statwalk.services.cancel import NEVER, CancelToken
from statwalk.services.library.upload_sandbox import answer_as_child, child_answer

PROCESSOR_SECONDS = 60
WALL_SECONDS = 120


def rig_in_child(
    model: Path, out: Path, name: str, wish: RigWish, token: CancelToken = NEVER
) -> dict[str, Any]:
    """Has a child rig a .glb, and write `out` and the checked character beside it; returns facts about the
    character.

    :raises ContentError: when the model cannot be rigged, or the child exceeds its memory or time.
    :raises CancelledError: when the token is cancelled; the child is killed.
    """
    arguments = [str(model), str(out), name, json.dumps(asdict(wish))]
    return child_answer("statwalk.services.library.rig_sandbox", arguments, out.parent, token, WALL_SECONDS)


def main(model: str, out: str, name: str, wish: str) -> None:
    """Runs the child."""
    answer_as_child(
        lambda: rigged(read_model(Path(model).read_bytes(), name), **json.loads(wish)),
        Path(out),
        PROCESSOR_SECONDS,
    )


if __name__ == "__main__":
    main(*sys.argv[1:])
