"""Reads an uploaded file in a child process with bounded memory and time, so that no file can
harm the server.

The child (`python -m statwalk.services.library.upload_sandbox UPLOAD OUT NAME`) writes the model as a .glb,
and beside it the checked character (`files.character_archive`), which the server loads. The server itself
never parses an uploaded file. The child prints one line of JSON: facts about the character, or why and where
the file is refused.
"""

from __future__ import annotations

import contextlib
import errno
import json
import logging
import os
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import asdict
from pathlib import Path
from typing import Any

from statwalk.character.character import Character
from statwalk.errors import ContentError, ModelError
from statwalk.files import archive, captures
from statwalk.files.character_archive import write_character
from statwalk.files.gltf import read_model
from statwalk.motion.filter_clip import Filter
from statwalk.services.cancel import NEVER, CancelToken

if sys.platform != "win32":
    import resource

MEMORY_BYTES = 1 << 30
PROCESSOR_SECONDS = 10
WALL_SECONDS = 15
POLL_SECONDS = 0.1
"""the time between two checks of the token"""
NICENESS = 10
"""lets the stages run before the child"""
LARGEST_MODEL_BYTES = 64 << 20
MOST_NOTES = 20
OUT_OF_MEMORY = f"reading it takes more than {MEMORY_BYTES >> 20} MiB of memory"
TOO_LARGE = f"its arrays take more than {archive.LARGEST_UNPACKED_BYTES >> 20} MiB"
OUT_OF_TIME = f"reading it takes more than {PROCESSOR_SECONDS} s of computing"
ONE_THREAD = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
log = logging.getLogger(__name__)


def read_in_child(
    upload: Path, out: Path, name: str, token: CancelToken = NEVER, how: captures.Reading | None = None
) -> dict[str, Any]:
    """Has a child read `upload`, and write `out`, a self-contained .glb, and `checked_beside(out)`; returns
    facts about the character. `how` says how a capture is read.

    Blocks for at most 15 s.

    :raises ContentError: when the file is refused, or the child exceeds its memory or time.
    :raises CancelledError: when the token is cancelled; the child is killed.
    """
    command = [
        sys.executable,
        "-P",
        "-m",
        "statwalk.services.library.upload_sandbox",
        str(upload),
        str(out),
        name,
        json.dumps(asdict(how or captures.Reading())),
    ]
    with subprocess.Popen(  # noqa: S603 - our own program, no shell
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=out.parent, env=os.environ | ONE_THREAD
    ) as child:
        try:
            output, error_output = _wait_for(child, token)
        finally:
            child.kill()
    if child.returncode:
        raise refusal(child.returncode, error_output)
    answer: dict[str, Any] = json.loads(output)
    if "message" in answer:
        raise ContentError(answer["message"], file=answer["file"], place=answer["place"])
    return answer


def checked_beside(model: Path) -> Path:
    """Returns the path of the checked character of a .glb: the same name with the suffix .npz."""
    return model.with_suffix(".npz")


def _wait_for(child: subprocess.Popen[bytes], token: CancelToken) -> tuple[bytes, bytes]:
    """Returns the child's standard output and standard error when it ends.

    :raises ContentError: when the child runs longer than 15 s.
    :raises CancelledError: when the token is cancelled.
    """
    deadline = time.monotonic() + WALL_SECONDS
    while time.monotonic() < deadline:
        token.check()
        with contextlib.suppress(subprocess.TimeoutExpired):
            return child.communicate(timeout=POLL_SECONDS)
    raise ContentError(f"reading it takes longer than {WALL_SECONDS} s")


def refusal(status: int, error_output: bytes) -> ContentError:
    """Returns the error for a child that ended with a status other than 0."""
    if sys.platform != "win32" and status in (-signal.SIGXCPU, -signal.SIGKILL):
        return ContentError(OUT_OF_TIME)
    tail = error_output[-2_000:].decode(errors="replace")
    log.error("the reader of an upload ended with status %d: %s", status, tail)
    return ContentError("the reader failed on this file; the file is refused")


def main(upload: str, out: str, name: str, how: str = "{}") -> None:
    """Runs the child: sets its limits, then reads the file."""
    _limit_self()
    answer: dict[str, Any]
    try:
        character = read_upload(Path(upload), name, _reading(how))
        answer = _checked_facts(character)
        write_character(character, checked_beside(Path(out)))
        Path(out).write_bytes(character.model_glb)
    except ContentError as error:
        answer = {"message": error.message[:2_000], "file": error.file[:200], "place": error.place[:500]}
    except OSError as error:
        if error.errno != errno.EFBIG:
            raise
        answer = {"message": TOO_LARGE, "file": "", "place": ""}
    except MemoryError:
        answer = {"message": OUT_OF_MEMORY, "file": "", "place": ""}
    sys.stdout.write(json.dumps(answer))


def _limit_self() -> None:
    if sys.platform != "win32":
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY_BYTES, MEMORY_BYTES))
        resource.setrlimit(resource.RLIMIT_CPU, (PROCESSOR_SECONDS, PROCESSOR_SECONDS + 1))
        resource.setrlimit(
            resource.RLIMIT_FSIZE, (archive.LARGEST_UNPACKED_BYTES, archive.LARGEST_UNPACKED_BYTES)
        )
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        os.nice(NICENESS)


def _reading(text: str) -> captures.Reading:
    members = json.loads(text)
    return captures.Reading(**{**members, "filter": Filter(**members.get("filter", {}))})


def read_upload(upload: Path, name: str, how: captures.Reading | None = None) -> Character:
    """Reads the character of a .glb, a self-contained .gltf, a zip, or a capture (.bvh, .trc).

    :raises ContentError: when the file is refused.
    """
    with upload.open("rb") as file:
        start = file.read(64)
    zipped, kind = archive.is_zip(start), captures.kind_of(start)
    if kind:
        return captures.read_capture(upload.read_bytes(), kind, name, how)
    if how is not None and how != captures.Reading():
        raise ContentError("position, scale and filters are for captures: .bvh and .trc files")
    if not zipped:
        return read_model(upload.read_bytes(), name)
    with tempfile.TemporaryDirectory(dir=upload.parent) as unpacked:
        model = archive.unpack(upload, Path(unpacked))
        try:
            return read_model(model.read_bytes(), name, model.parent)
        except ContentError as error:
            raise error.in_file(str(model.relative_to(unpacked))) from None


def _checked_facts(character: Character) -> dict[str, Any]:
    """Samples every clip and poses the skin once; returns the numbers of joints, clips, skins and vertices.

    :raises ModelError: when the model with its files is too large.
    """
    if len(character.model_glb) > LARGEST_MODEL_BYTES:
        raise ModelError(
            f"the model with its files has {len(character.model_glb)} bytes; it may have "
            f"{LARGEST_MODEL_BYTES >> 20} MiB at most"
        )
    for clip in character.clips.values():
        character.world(clip.sample(clip.duration / 2))
    character.vertices(character.bind_pose)
    return {
        "joints": len(character.skeleton.names),
        "clips": len(character.clips),
        "skins": len(character.skins),
        "vertices": sum(len(part.positions) for part in character.parts),
        "notes": list(character.notes[:MOST_NOTES]),
    }


if __name__ == "__main__":
    main(*sys.argv[1:])
