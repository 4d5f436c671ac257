"""Single changes to a valid glTF file: each takes a source of chance, the JSON and the binary chunk, and
changes either in place.
"""

import json
import struct
from copy import deepcopy

import numpy as np

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
NUMBERS = [
    0,
    1,
    2,
    3,
    4,
    5,
    7,
    255,
    5120,
    5121,
    5123,
    5125,
    5126,
    65535,
    1 << 31,
    (1 << 32) - 1,
    1 << 40,
    (1 << 63) - 1,
    -1,
    -2,
]
FLOATS = [0.0, -0.0, 0.5, 1e-45, 1e-30, 1e30, 3.4e38, -3.4e38, 1e39, 1e308, 1.5]
ODD = [None, True, False, [], {}, [0], [[]], {"a": {}}]
BAD_FLOATS = [np.nan, np.inf, -np.inf, 3.4e38, -3.4e38, 1e30, 1e-45, 0.0, -1.0]


def places(value):
    """Every (container, key) in a JSON value."""
    found, ready = [], [value]
    while ready:
        entry = ready.pop()
        keys = (
            list(entry) if isinstance(entry, dict) else range(len(entry)) if isinstance(entry, list) else []
        )
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
    return deepcopy(random.choice(random.choice([WORDS, NUMBERS, FLOATS, ODD])))


def replace(random, root, binary):
    container, key = random.choice(places(root))
    container[key] = other_value(random, container[key])


def remove(random, root, binary):
    container, key = random.choice(places(root))
    del container[key]


def double(random, root, binary):
    lists = [entry[key] for entry, key in places(root) if isinstance(entry[key], list) and entry[key]]
    chosen = random.choice(lists)
    chosen.insert(random.randrange(len(chosen) + 1), deepcopy(random.choice(chosen)))


def swap(random, root, binary):
    (left, a), (right, b) = random.sample(places(root), 2)
    left[a], right[b] = json.loads(json.dumps([right[b], left[a]]))


def repoint(random, root, binary):
    """An index changed to another that may exist: the file stays whole, but means something else."""
    named = [(entry, key) for entry, key in places(root) if type(entry[key]) is int]
    container, key = random.choice(named)
    container[key] = (
        random.choice(named)[0].get("count", 0)
        if random.random() < 0.1 and isinstance(named[0][0], dict)
        else random.randrange(12)
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
        "indices": {
            "bufferView": random.randrange(views),
            "componentType": random.choice([5121, 5123, 5125]),
        },
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
        data[start : start + 4] = struct.pack(
            "<I", random.choice([0, 1, 2, 20, len(data), 1 << 31, (1 << 32) - 1])
        )
    else:
        size = int.from_bytes(data[12:16], "little")
        for _ in range(random.choice([1, 3, 20])):
            data[20 + random.randrange(size)] = (
                random.randrange(32, 127) if kind == 2 else random.randrange(256)
            )
    return bytes(data)
