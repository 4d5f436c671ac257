"""Compares captures with pybvh, which reads BVH files too: how far apart both have the joints, and how long
the largest file takes to read: `python benchmarks/captures.py`, or with the names of BVH files behind it.

The captures are random trees of joints; each joint has its own order of rotation channels.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Iterator, Sequence
from functools import partial
from itertools import permutations
from pathlib import Path

import numpy as np
import pybvh
from numpy.typing import NDArray
from rounds import least, show
from statwalk.character.character import Character
from statwalk.files.bvh import read_bvh
from statwalk.rig.evaluate import world_from_local

CAPTURES, FRAMES, RATE, ROUNDS = 40, 50, 1 / 60, 5
ORDERS = tuple(" ".join(f"{axis}rotation" for axis in order) for order in permutations("XYZ"))


def random_capture(seed: int) -> str:
    """Returns the text of a BVH file: 2 to 60 joints."""
    chance = np.random.default_rng(seed)
    count = int(chance.integers(2, 61))
    parents = [-1, *(int(chance.integers(max(0, child - 4), child)) for child in range(1, count))]
    lines = [
        "HIERARCHY",
        *_joint(0, parents, chance),
        "MOTION",
        f"Frames: {FRAMES}",
        f"Frame Time: {RATE:.6f}",
    ]
    values = chance.uniform(-180, 180, (FRAMES, 3 * count + 3))
    return "\n".join([*lines, *(" ".join(f"{number:.6f}" for number in row) for row in values)]) + "\n"


def _joint(joint: int, parents: Sequence[int], chance: np.random.Generator) -> Iterator[str]:
    """The lines of a joint and of those below it."""
    places = "Xposition Yposition Zposition "
    channels = (places if joint == 0 else "") + ORDERS[chance.integers(len(ORDERS))]
    yield f"{'ROOT' if joint == 0 else 'JOINT'} joint{joint}"
    yield from ("{", _offset(chance), f"CHANNELS {len(channels.split())} {channels}")
    below = [child for child, parent in enumerate(parents) if parent == joint]
    for child in below:
        yield from _joint(child, parents, chance)
    if not below:
        yield from ("End Site", "{", _offset(chance), "}")
    yield "}"


def _offset(chance: np.random.Generator) -> str:
    return "OFFSET " + " ".join(f"{number:.6f}" for number in chance.uniform(-30, 30, 3))


def places(capture: Character) -> NDArray[np.float32]:
    """Returns (F, J, 3) where the joints of a capture are in each frame."""
    (clip,) = capture.clips.values()
    return world_from_local(capture.skeleton, clip.sample(clip.channels[0].times))[..., 3]


def apart(path: Path) -> float:
    """Returns how far statwalk's place of a joint is from pybvh's at most, in sizes of the motion."""
    theirs = pybvh.read_bvh_file(path).node_positions()
    ours = places(read_bvh(path.read_bytes(), path.stem))
    return float(np.linalg.norm(ours - theirs, axis=-1).max() / np.ptp(theirs, (0, 1)).max())


def read(path: Path) -> None:
    """Reads a capture as `statwalk.load` does."""
    read_bvh(path.read_bytes(), path.stem)


def read_by_pybvh(path: Path) -> None:
    """Reads a capture with pybvh."""
    pybvh.read_bvh_file(path)


def main() -> None:
    """Prints the table."""
    with tempfile.TemporaryDirectory() as temporary:
        paths = [Path(name) for name in sys.argv[1:]]
        for seed in range(0 if paths else CAPTURES):
            paths.append(Path(temporary) / f"{seed}.bvh")
            paths[-1].write_text(random_capture(seed))
        farthest = max(map(apart, paths))
        print(f"joints in {len(paths)} captures: at most {farthest:.1e} of the size of the motion apart")
        largest = max(paths, key=lambda path: path.stat().st_size)
        jobs = {"statwalk": partial(read, largest), "pybvh": partial(read_by_pybvh, largest)}
        show(f"reading {largest.stat().st_size / 1e6:.1f} MB of BVH", least(jobs, ROUNDS))


if __name__ == "__main__":
    main()
