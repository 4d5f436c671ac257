"""What every mutated file must end in: a Character that moves and has finite numbers only, or an error that
names a place, within SECONDS.
"""

import json
import resource
import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.gltf.template import FrameTemplate, PosedCast
from statwalk.skin.collapses import fault

SECONDS = 5
FAR = 1e30
"""metres: the error of a level that has all collapses"""


@contextmanager
def limited(seconds: float) -> Iterator[None]:
    """An alarm for what hangs; whoever had set one finds it again."""

    def ring(*_: object) -> None:
        raise TimeoutError(f"longer than {seconds} s")

    previous = signal.signal(signal.SIGALRM, ring)
    remaining, _ = signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.signal(signal.SIGALRM, previous)
        signal.setitimer(signal.ITIMER_REAL, remaining)


def outcome(
    read: Callable[[], Character],
    places: tuple[str, ...],
    error: type[ContentError] = ContentError,
    then: Callable[[Character], str] = lambda _character: "read",
) -> str:
    """`refused`, or the word of `then`, which gets what was read; raises where the reader breaks. A place
    begins with one of `places`.
    """
    with limited(SECONDS):
        try:
            character = read()
        except error as refusal:
            if not refusal.place.startswith(places):
                raise ValueError(f"no place: {refusal}") from refusal
            return "refused"
        use(character)
        return then(character)


def use(character: Character) -> None:
    """Moves it as a stage would, draws its coarsest level, and looks at all numbers that leave it."""
    poses = [character.bind_pose]
    poses += [
        clip.sample(clip.duration * part) for clip in list(character.clips.values())[:4] for part in (0.3, 1)
    ]
    for pose in poses:
        finite(*pose, character.world(pose))
        for part in character.vertices(pose):
            finite(part.positions, *([] if part.normals is None else [part.normals]))
    one = poses[-1]
    cast = PosedCast(type(one)(*(array[None] for array in one)), np.zeros((1, 3)), np.zeros(1))
    frame = FrameTemplate([(character, 1)], images=True).frame(1, "", [cast])
    json.loads(frame[20 : 20 + int.from_bytes(frame[12:16], "little")])
    if character.levels:
        _coarse(character)


def _coarse(character: Character) -> None:
    for part in character.parts:
        assert part.collapses is None or fault(part.collapses, len(part.positions)) == ""
    for coarse in character.lod(error=FAR).parts:
        assert coarse.indices is None or int(coarse.indices.max()) < len(coarse.positions)
        finite(coarse.positions)


def finite(*arrays: np.ndarray) -> None:
    assert all(np.isfinite(array).all() for array in arrays), "a number that is not finite"


def memory(process: int | str = "self") -> int:
    """Bytes a process has in memory now (Linux)."""
    return int(Path(f"/proc/{process}/statm").read_text().split()[1]) * resource.getpagesize()
