"""Seeded, structured mutations of valid glTF files, and what every one of them must end in.

    python tests/torture/mutate.py 100000            # prints what broke, with the seed that shows it again
    python tests/torture/mutate.py 1 --seed 4711     # one of them

Each ends in a Character that moves and has finite numbers only, or in a ContentError that names a place, within 5 s; no other exception.
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

from statwalk.errors import ContentError
from statwalk.files.glb import read_model
from statwalk.files.glb.template import FrameTemplate, PosedCast
from tinymodel import document
from where import GLTF

SECONDS = 5
LARGEST_SOURCE_BYTES = 400_000
WORDS = [
    "",
    "SCALAR",
    "VEC2",
    "VEC3",
    "VEC4",
    "MAT3",
    "MAT4",
    "STEP",
    "LINEAR",
    "CUBICSPLINE",
    "translation",
    "weights",
    "\ud7ff",
    "%s%n",
    "a" * 999,
]
NUMBERS = [0, 1, 2, 3, 4, 5, 7, 255, 5120, 5121, 5123, 5125, 5126, 65535, 1 << 31, (1 << 32) - 1, 1 << 40, (1 << 63) - 1, -1, -2]
FLOATS = [0.0, -0.0, 0.5, 1e-45, 1e-30, 1e30, 3.4e38, -3.4e38, 1e39, 1e308, 1.5]
ODD = [None, True, False, [], {}, [0], [[]], {"a": {}}]
BAD_FLOATS = [np.nan, np.inf, -np.inf, 3.4e38, -3.4e38, 1e30, 1e-45, 0.0, -1.0]


def split(data):
    """JSON and binary chunk of a valid GLB."""
    size = int.from_bytes(data[12:16], "little")
    return json.loads(data[20 : 20 + size]), bytearray(data[28 + size :])


def join(root, binary):
    """A GLB of them."""
    text = json.dumps(root).encode("utf-8", "surrogatepass")
    text += b" " * (-len(text) % 4)
    binary = bytes(binary) + b"\0" * (-len(binary) % 4)
    body = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(binary), 0x004E4942) + binary
    return struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body


def sources():
    """JSON and binary of the files that are mutated: the tiny model, and small real ones where they are."""
    real = sorted(GLTF.rglob("*.glb")) if GLTF.is_dir() else []
    return [document(), *(split(path.read_bytes()) for path in real if path.stat().st_size < LARGEST_SOURCE_BYTES)]


def places(value):
    """Every (container, key) in a JSON value."""
    found, ready = [], [value]
    while ready:
        entry = ready.pop()
        keys = list(entry) if isinstance(entry, dict) else range(len(entry)) if isinstance(entry, list) else []
        found += [(entry, key) for key in keys]
        ready += [entry[key] for key in keys if isinstance(entry[key], (dict, list))]
    return found


def other_value(random, old):
    """A value in place of another: near it, or of any kind."""
    choice = random.random()
    if type(old) is int and choice < 0.4:
        return old + random.choice([-4, -1, 1, 2, 3, 1000])
    if isinstance(old, float) and choice < 0.3:
        return old * random.choice([-1, 0, 1e20, 1e38])
    return random.choice(random.choice([WORDS, NUMBERS, FLOATS, ODD]))


def replace(random, root, binary):
    container, key = random.choice(places(root))
    container[key] = other_value(random, container[key])


def remove(random, root, binary):
    container, key = random.choice(places(root))
    del container[key]


def double(random, root, binary):
    lists = [entry[key] for entry, key in places(root) if isinstance(entry[key], list) and entry[key]]
    chosen = random.choice(lists)
    chosen.insert(random.randrange(len(chosen) + 1), random.choice(chosen))


def swap(random, root, binary):
    (left, a), (right, b) = random.sample(places(root), 2)
    left[a], right[b] = json.loads(json.dumps([right[b], left[a]]))


def repoint(random, root, binary):
    """An index changed to another that may exist: the file stays whole, but means something else."""
    named = [(entry, key) for entry, key in places(root) if type(entry[key]) is int]
    container, key = random.choice(named)
    container[key] = (
        random.choice(named)[0].get("count", 0) if random.random() < 0.1 and isinstance(named[0][0], dict) else random.randrange(12)
    )


def bad_floats(random, root, binary):
    for _ in range(random.choice([1, 5, 100])):
        start = random.randrange(0, max(len(binary) - 4, 1), 4)
        binary[start : start + 4] = np.float32(random.choice(BAD_FLOATS)).tobytes()


def bad_bytes(random, root, binary):
    for _ in range(random.choice([1, 10, 500])):
        binary[random.randrange(len(binary))] = random.randrange(256)


def cut_binary(random, root, binary):
    del binary[random.randrange(len(binary)) :]


def sparse(random, root, binary):
    entry = random.choice(root["accessors"])
    views = len(root["bufferViews"])
    entry["sparse"] = {
        "count": random.choice([1, 2, 3, 1 << 33]),
        "indices": {"bufferView": random.randrange(views), "componentType": random.choice([5121, 5123, 5125])},
        "values": {"bufferView": random.randrange(views)},
    }


def large_counts(random, root, binary):
    entry = random.choice(root["accessors"])
    entry["count"] = random.choice([10**7, 6 * 10**7, 4 * 10**9, 10**18])
    if random.random() < 0.5:
        entry.pop("bufferView", None)


def loop_nodes(random, root, binary):
    nodes = root["nodes"]
    for _ in range(random.choice([1, 3])):
        random.choice(nodes).setdefault("children", []).append(random.randrange(len(nodes)))


CHANGES = (
    [replace] * 6
    + [remove] * 3
    + [repoint] * 3
    + [swap, double, bad_floats, bad_bytes, bad_floats, cut_binary, sparse, large_counts, loop_nodes]
)


def bent_container(random, data):
    """Header, chunk headers or the length changed; or any bytes of the text."""
    data = bytearray(data)
    kind = random.randrange(4)
    if kind == 0:
        return bytes(data[: random.randrange(len(data))])
    if kind == 1:
        start = random.choice([0, 4, 8, 12, 16])
        data[start : start + 4] = struct.pack("<I", random.choice([0, 1, 2, 20, len(data), 1 << 31, (1 << 32) - 1]))
    else:
        size = int.from_bytes(data[12:16], "little")
        for _ in range(random.choice([1, 3, 20])):
            data[20 + random.randrange(size)] = random.randrange(32, 127) if kind == 2 else random.randrange(256)
    return bytes(data)


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
    poses += [clip.sample(clip.duration * part) for clip in list(character.clips.values())[:4] for part in (0.3, 1)]
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


def memory():
    """Bytes this process has in memory now (Linux)."""
    return int(Path("/proc/self/statm").read_text().split()[1]) * resource.getpagesize()


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
