"""Seeded, structured mutations of valid glTF files, and what every one of them must end in.

    python tests/support/torture/mutate.py 100000            # prints what broke, with the seed that shows it
    again
    python tests/support/torture/mutate.py 1 --seed 4711     # one of them

Each ends in a Character that moves and has finite numbers only, or in a ContentError that names a place,
within 5 s; no other exception.
"""

import json
import random
import resource
import signal
import struct
import sys
import time
import traceback
from collections import Counter
from contextlib import contextmanager
from pathlib import Path

import numpy as np

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from paths import GLTF
from statwalk.errors import ContentError
from statwalk.files.gltf import read_model
from statwalk.files.gltf.template import FrameTemplate, PosedCast
from tiny_model import document
from torture.changes import CHANGES, bent_container

SECONDS = 5
LARGEST_SOURCE_BYTES = 400_000


def split(data):
    """JSON and binary chunk of a valid GLB."""
    size = int.from_bytes(data[12:16], "little")
    return json.loads(data[20 : 20 + size]), bytearray(data[28 + size :])


def join(root, binary):
    """A GLB of them."""
    text = json.dumps(root).encode("utf-8", "surrogatepass")
    text += b" " * (-len(text) % 4)
    binary = bytes(binary) + b"\0" * (-len(binary) % 4)
    body = (
        struct.pack("<II", len(text), 0x4E4F534A)
        + text
        + struct.pack("<II", len(binary), 0x004E4942)
        + binary
    )
    return struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body


def sources():
    """JSON and binary of the files that are mutated: the tiny model, and small real ones where they are."""
    real = sorted(GLTF.rglob("*.glb")) if GLTF.is_dir() else []
    return [
        document(),
        *(split(path.read_bytes()) for path in real if path.stat().st_size < LARGEST_SOURCE_BYTES),
    ]


def mutated(seed, known):
    """The file of a seed: one of the known sources with one to four changes."""
    chance = random.Random(seed)
    root, binary = chance.choice(known)
    root, binary = json.loads(json.dumps(root)), bytearray(binary)
    for _ in range(chance.choice([1, 1, 1, 3])):
        try:
            chance.choice(CHANGES)(chance, root, binary)
        except (KeyError, IndexError, ValueError, TypeError, AttributeError):
            continue  # an earlier change took away what this one needs
    data = join(root, binary)
    return bent_container(chance, data) if chance.random() < 0.1 else data


@contextmanager
def limited(seconds):
    """An alarm for what hangs; whoever had set one finds it again."""

    def ring(*_):
        raise TimeoutError(f"longer than {seconds} s")

    previous = signal.signal(signal.SIGALRM, ring)
    remaining, _ = signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.signal(signal.SIGALRM, previous)
        signal.setitimer(signal.ITIMER_REAL, remaining)


def outcome(data):
    """`read` or `refused`; raises for all that must not be."""
    with limited(SECONDS):
        try:
            character = read_model(data, "mutated")
        except ContentError as error:
            if not error.place.startswith(("/", "byte ")):
                raise ValueError(f"no place: {error}") from error
            return "refused"
        use(character)
        return "read"


def use(character):
    """Move it as a stage would, and look at all numbers that leave it."""
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


def finite(*arrays):
    assert all(np.isfinite(array).all() for array in arrays), "a number that is not finite"


def memory(process="self"):
    """Bytes a process has in memory now (Linux)."""
    return int(Path(f"/proc/{process}/statm").read_text().split()[1]) * resource.getpagesize()


def main(count, first=0):
    """Run seeds first … first + count, print what broke and what came of the rest."""
    known = sources()
    results, slowest, before = Counter(), (0.0, 0), 0
    for seed in range(first, first + count):
        data, start = mutated(seed, known), time.perf_counter()
        try:
            results[outcome(data)] += 1
        except Exception:
            results["broken"] += 1
            print(f"seed {seed}:\n{traceback.format_exc(limit=-3)}")
        slowest = max(slowest, (time.perf_counter() - start, seed))
        before = memory() if seed - first in (0, 200) else before
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss >> 10
    print(f"{dict(results)}; slowest {slowest[0]:.2f} s (seed {slowest[1]})")
    print(f"memory {(memory() - before) / 2**20:+.0f} MiB since the first 200 files, peak {peak} MiB")
    return results["broken"]


if __name__ == "__main__":
    seed = int(sys.argv[sys.argv.index("--seed") + 1]) if "--seed" in sys.argv else 0
    sys.exit(main(int(sys.argv[1]), seed) > 0)
