"""Motions with all kinds of keys, and a crowd that plays them."""

import gaits
import lane_kernels
import numpy as np
from statwalk.maths.pose import rest
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.motion.blend_space import BlendSpace
from statwalk.motion.clip import Channel, Clip, duration_of
from statwalk.motion.root import STANDING, extract
from statwalk.motion.single import Single

JOINTS, WEIGHTS, ACTORS = 23, 5, 37
REST = rest(JOINTS, WEIGHTS)
KINDS = ("STEP", "LINEAR", "CUBICSPLINE", "BSPLINE", "BSPLINE_THROUGH", "NURBS")
MARKS = ((("a", 0.1), ("b", 0.6)), (("a", 0.3), ("b", 0.7)), (("a", 0.9), ("b", 0.5)))
PLANE, LINE = np.array([[0.0, 0], [1, 0], [0.3, 1]]), np.array([[3.0], [1], [2]])


def random_clip(seed, kinds=KINDS, in_step=True, loop=False):
    """Half of all channels; their key times the same, or some of common ones, or their own."""
    rng = np.random.default_rng(seed)
    grid = np.sort(rng.uniform(0, 2, 9)).astype(np.float32)

    def times():
        if in_step:
            return grid
        own = rng.uniform(0, 2, 9).astype(np.float32)
        return np.unique(rng.choice(grid if rng.random() < 0.7 else own, rng.integers(2, 9)))

    def values(path, kind, count):
        width = {"translation": 3, "rotation": 4, "scale": 3, "weights": WEIGHTS}[path]
        shape = (count, 3, width) if kind == "CUBICSPLINE" else (count, width)
        keys = rng.normal(size=shape)
        if path == "rotation" and kind == "BSPLINE_THROUGH":
            keys = np.array([0, 0, 0, 1]) + 0.05 * keys
        return (keys[:1].repeat(count, 0) if rng.random() < 0.2 else keys).astype(np.float32)

    def channel(joint, path):
        kind, keys = kinds[rng.integers(len(kinds))], times()
        return Channel(joint, path, keys, values(path, kind, len(keys)), kind)

    paths = [
        (joint, path)
        for joint in range(JOINTS)
        for path in ("translation", "rotation", "scale")
        if rng.random() < 0.5
    ]
    channels = [*(channel(*where) for where in paths), channel(0, "weights")]
    return Clip(f"clip {seed}", tuple(channels), duration_of(channels), REST, loop=loop)


def motions(in_step):
    clips = [Single(random_clip(seed, in_step=in_step), STANDING) for seed in range(3)]
    parts = tuple(
        Single(random_clip(seed, ("LINEAR",), in_step, loop=True), STANDING) for seed in range(5, 8)
    )
    return [
        *clips,
        None,
        BlendSpace(parts, PLANE, (0, 1), MARKS, True),
        BlendSpace(parts, LINE, (1,), MARKS, True),
    ]


def crowd(states=6):
    rng = np.random.default_rng(9)
    return (
        rng.integers(-1, states, (ACTORS, 2)),
        rng.uniform(-0.2, 2.3, (ACTORS, 2)),
        rng.uniform(-1, 4, (ACTORS, 2)),
    )


def blocks(tables, states, times, parameters, layer=1):
    """What the compiled code makes of actors: a buffer full of other numbers is overwritten."""
    buffer = PoseBuffer.at_rest(REST, len(states))
    buffer.values[:] = 7
    memory = np.empty(tables.most_members), np.empty(tables.memory, np.float32)
    lane_kernels.sample_all(tables, states, times, layer, False, parameters, *memory, buffer.values)
    return buffer


def walks():
    parts = tuple(Single(*extract(clip, gaits.HIPS, True)) for clip in (gaits.WALK, gaits.RUN))
    marks = tuple(
        tuple(zip(("left", "right"), downs, strict=True)) for downs in (gaits.WALK_DOWN, gaits.RUN_DOWN)
    )
    once = Single(*extract(gaits.WALK, gaits.HIPS, False))
    return [BlendSpace(parts, np.array([[1.2], [4.0]]), (0,), marks, True), parts[0], once]
