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
import time
from collections.abc import Callable
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

from statwalk.character.character import Character
from statwalk.errors import ContentError, ModelError, StorageError
from statwalk.files import archive, captures, model_formats
from statwalk.files.character_archive import write_character
from statwalk.files.character_file import load_zip
from statwalk.files.md2 import md2_header, read_md2
from statwalk.files.md2.md2_file import Inbetween
from statwalk.files.without_meshes import without_meshes
from statwalk.motion.filter_clip import Filter
from statwalk.services.cancel import NEVER, CancelToken
from statwalk.services.work.limited_process import limit_self, started

MEMORY_BYTES = 1 << 30
PROCESSOR_SECONDS = 10
WALL_SECONDS = 60
"""long, because a busy server runs the child last, and its start counts: what a file costs is bounded by
PROCESSOR_SECONDS
"""
POLL_SECONDS = 0.1
"""the time between two checks of the token"""
LARGEST_MODEL_BYTES = 64 << 20
MOST_NOTES = 20
OUT_OF_MEMORY = f"reading it takes more than {MEMORY_BYTES >> 20} MiB of memory"
TOO_LARGE = f"its arrays take more than {archive.LARGEST_UNPACKED_BYTES >> 20} MiB"
OUT_OF_TIME = f"reading it takes more than {PROCESSOR_SECONDS} s of computing"
REFUSALS = errno.ENOSPC, errno.EDQUOT, errno.EROFS, errno.EIO
"""errors of a disk that does not take what the child writes"""
log = logging.getLogger(__name__)


def read_in_child(
    upload: Path, out: Path, name: str, token: CancelToken = NEVER, how: captures.Reading | None = None
) -> dict[str, Any]:
    """Has a child read `upload`, and write `out`, a self-contained .glb, and `checked_beside(out)`; returns
    facts about the character. `how` says how it is read.

    Blocks for at most 60 s.

    :raises ContentError: when the file is refused, or the child exceeds its memory or time.
    :raises StorageError: when the disk refuses what the child writes.
    :raises CancelledError: when the token is cancelled; the child is killed.
    """
    arguments = [str(upload), str(out), name, json.dumps(asdict(how or captures.Reading()))]
    module = "statwalk.services.library.upload_sandbox"
    return child_answer(module, arguments, out.parent, token, WALL_SECONDS)


def child_answer(
    module: str, arguments: list[str], folder: Path, token: CancelToken, seconds: float
) -> dict[str, Any]:
    """Runs a module of ours in a child process in `folder`; returns the line of JSON that it prints.

    :raises ContentError: when the child refuses the file, or exceeds its memory or `seconds`.
    :raises StorageError: when the disk refuses what the child writes.
    :raises CancelledError: when the token is cancelled; the child is killed.
    """
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    with started(module, arguments, runs_last=True, cwd=folder, **pipes) as child:
        try:
            output, error_output = _wait_for(child, token, seconds)
        finally:
            child.kill()
    if child.returncode:
        raise refusal(child.returncode, error_output)
    answer: dict[str, Any] = json.loads(output)
    if "errno" in answer:
        raise StorageError.of(OSError(answer["errno"], os.strerror(answer["errno"])), "the data folder")
    if "message" in answer:
        raise ContentError(answer["message"], file=answer["file"], place=answer["place"])
    return answer


def checked_beside(model: Path) -> Path:
    """Returns the path of the checked character of a .glb: the same name with the suffix .npz."""
    return model.with_suffix(".npz")


def _wait_for(child: subprocess.Popen[bytes], token: CancelToken, seconds: float) -> tuple[bytes, bytes]:
    """Returns the child's standard output and standard error when it ends.

    :raises ContentError: when the child runs longer than `seconds`.
    :raises CancelledError: when the token is cancelled.
    """
    deadline = time.monotonic() + seconds
    while time.monotonic() < deadline:
        token.check()
        with contextlib.suppress(subprocess.TimeoutExpired):
            return child.communicate(timeout=POLL_SECONDS)
    raise ContentError(f"reading it takes longer than {seconds:g} s")


def refusal(status: int, error_output: bytes) -> ContentError:
    """Returns the error for a child that ended with a status other than 0."""
    if sys.platform != "win32" and status in (-signal.SIGXCPU, -signal.SIGKILL):
        return ContentError(OUT_OF_TIME)
    tail = error_output[-2_000:].decode(errors="replace")
    log.error("the reader of an upload ended with status %d: %s", status, tail)
    return ContentError("the reader failed on this file; the file is refused")


def main(upload: str, out: str, name: str, how: str = "{}") -> None:
    """Runs the child that reads an upload."""
    answer_as_child(lambda: read_upload(Path(upload), name, _reading(how)), Path(out), PROCESSOR_SECONDS)


def answer_as_child(
    character_of: Callable[[], Character], out: Path, seconds: int = PROCESSOR_SECONDS
) -> None:
    """Sets the limits of this process, makes a character, writes its model and the checked character, and
    prints the facts, or the reason why it is refused.
    """
    limit_self(MEMORY_BYTES, archive.LARGEST_UNPACKED_BYTES, seconds)
    answer: dict[str, Any]
    try:
        character = character_of()
        answer = _checked_facts(character)
        write_character(character, checked_beside(out))
        out.write_bytes(character.model_glb)
    except ContentError as error:
        answer = {"message": error.message[:2_000], "file": error.file[:200], "place": error.place[:500]}
    except OSError as error:
        if error.errno not in (errno.EFBIG, *REFUSALS):
            raise
        too_large = {"message": TOO_LARGE, "file": "", "place": ""}
        answer = too_large if error.errno == errno.EFBIG else {"errno": error.errno}
    except MemoryError:
        answer = {"message": OUT_OF_MEMORY, "file": "", "place": ""}
    sys.stdout.write(json.dumps(answer))


def _reading(text: str) -> captures.Reading:
    members = json.loads(text)
    made = {"filter": Filter(**members.get("filter", {})), "without": tuple(members.get("without", ()))}
    return captures.Reading(**{**members, **made})


def read_upload(upload: Path, name: str, how: captures.Reading | None = None) -> Character:
    """Reads the character of a zip, or of a file of any format that stands alone (`model_formats`), without
    the meshes to leave out.

    :raises ContentError: when the file is refused.
    """
    how = how or captures.Reading()
    return without_meshes(_read_whole(upload, name, replace(how, without=())), how.without)


def _read_whole(upload: Path, name: str, how: captures.Reading) -> Character:
    with upload.open("rb") as file:
        start = file.read(64)
    kind = captures.kind_of(start)
    if kind:
        return captures.read_capture(upload.read_bytes(), kind, name, how)
    if start.startswith(md2_header.START):
        return read_md2(upload.read_bytes(), name, *_of_md2(how))
    if how != captures.Reading():
        raise ContentError("position, scale and filters are for captures, .bvh and .trc; inbetween for .md2")
    if not archive.is_zip(start):
        return model_formats.format_that_starts(start).read_bytes(upload.read_bytes(), name)
    return load_zip(upload, name, upload.parent)


def _of_md2(how: captures.Reading) -> tuple[Inbetween, float]:
    if how != captures.Reading(scale=how.scale, inbetween=how.inbetween):
        raise ContentError("position and filters are for captures: .bvh and .trc files")
    return how.inbetween, how.scale


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
