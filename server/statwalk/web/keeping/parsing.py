"""Reading a stranger's file in a child process of bounded memory and time, so that nothing in it can harm the server.

The child (`python -m statwalk.web.keeping.parsing UPLOAD OUT NAME`) writes the model as a .glb and answers with one line of JSON: facts
about the character, or why the file is refused, and where.
"""

from __future__ import annotations

import json
import logging
import os
import signal
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

from statwalk.character import Character
from statwalk.errors import ContentError, ModelError
from statwalk.files import bundle
from statwalk.files.glb import read_model
from statwalk.maths.kernels import choose

if sys.platform != "win32":
    import resource

MEMORY_BYTES = 1 << 30
PROCESSOR_SECONDS = 10
WALL_SECONDS = 15
NICENESS = 10
"""the stages go first"""
LARGEST_MODEL_BYTES = 64 << 20
MOST_NOTES = 20
OUT_OF_MEMORY = f"reading it takes more than {MEMORY_BYTES >> 20} MiB of memory"
OUT_OF_TIME = f"reading it takes more than {PROCESSOR_SECONDS} s of computing"
ONE_THREAD = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
log = logging.getLogger(__name__)


def read_in_child(upload: Path, out: Path, name: str) -> dict[str, Any]:
    """Has a child read `upload` and write `out`, a self-contained .glb; facts about the character. Blocks for at most 15 s.

    :raises ContentError: if the file is refused, or reading it takes more than the child may have.
    """
    command = [sys.executable, "-P", "-m", "statwalk.web.keeping.parsing", str(upload), str(out), name]
    try:
        ended = subprocess.run(  # noqa: S603 - our own program, no shell
            command, capture_output=True, timeout=WALL_SECONDS, check=False, cwd=out.parent, env=os.environ | ONE_THREAD
        )
    except subprocess.TimeoutExpired:
        raise ContentError(f"reading it takes longer than {WALL_SECONDS} s") from None
    if ended.returncode:
        raise refusal(ended.returncode, ended.stderr)
    answer: dict[str, Any] = json.loads(ended.stdout)
    if "message" in answer:
        raise ContentError(answer["message"], file=answer["file"], place=answer["place"])
    return answer


def refusal(status: int, said: bytes) -> ContentError:
    """Why a child without an answer ended."""
    if sys.platform != "win32" and status in (-signal.SIGXCPU, -signal.SIGKILL):
        return ContentError(OUT_OF_TIME)
    log.error("the reader of an upload ended with status %d: %s", status, said[-2_000:].decode(errors="replace"))
    return ContentError("the reader failed on this file; it is not taken")


def main(upload: str, out: str, name: str) -> None:
    """The child: limits first, then the file. It poses once: compiled kernels would not be worth their import."""
    limit_self()
    os.environ[choose.VARIABLE] = "numpy"
    answer: dict[str, Any]
    try:
        character = read_upload(Path(upload), name)
        answer = checked_facts(character)
        Path(out).write_bytes(character.model_glb)
    except ContentError as error:
        answer = {"message": error.message[:2_000], "file": error.file[:200], "place": error.place[:500]}
    except MemoryError:
        answer = {"message": OUT_OF_MEMORY, "file": "", "place": ""}
    sys.stdout.write(json.dumps(answer))


def limit_self() -> None:
    """No more memory, time and disk than reading a model needs."""
    if sys.platform != "win32":
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY_BYTES, MEMORY_BYTES))
        resource.setrlimit(resource.RLIMIT_CPU, (PROCESSOR_SECONDS, PROCESSOR_SECONDS + 1))
        resource.setrlimit(resource.RLIMIT_FSIZE, (bundle.LARGEST_UNPACKED_BYTES, bundle.LARGEST_UNPACKED_BYTES))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        os.nice(NICENESS)


def read_upload(upload: Path, name: str) -> Character:
    """The character of a .glb, a self-contained .gltf, or a zip."""
    with upload.open("rb") as file:
        zipped = bundle.is_zip(file.read(4))
    if not zipped:
        return read_model(upload.read_bytes(), name)
    with tempfile.TemporaryDirectory(dir=upload.parent) as unpacked:
        model = bundle.unpack(upload, Path(unpacked))
        try:
            return read_model(model.read_bytes(), name, model.parent)
        except ContentError as error:
            raise error.in_file(str(model.relative_to(unpacked))) from None


def checked_facts(character: Character) -> dict[str, Any]:
    """What there is in a character, after every clip was sampled and the skin was posed once."""
    if len(character.model_glb) > LARGEST_MODEL_BYTES:
        raise ModelError(f"the model with its files has {len(character.model_glb)} bytes; at most {LARGEST_MODEL_BYTES >> 20} MiB are kept")
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
