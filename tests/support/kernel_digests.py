"""What kernels make of fixed inputs, as hashes by name: `main` prints them.

A kernel is added as a function below that returns the arrays it wrote. Kernels that were compiled now, and
not taken from the disk, can be looked into: `newer` lists what one of them uses that not every processor has.
"""

import hashlib
import json
import shutil
import tempfile
from contextlib import suppress
from pathlib import Path

import ik_chains
import numpy as np
import random_motions
import wild_machines
from paths import MACHINES
from playing import role_of
from statwalk.errors import StageError
from statwalk.files.gltf import _kernels as reading
from statwalk.maths import compiling, quat
from statwalk.maths.clamp_kinds import CONE, EULER, HINGE, RANGE
from statwalk.maths.clamp_table import JointLimit
from statwalk.motion.keys import _kernels as keys
from statwalk.motion.tables.build import tables_of
from statwalk.rig import _kernels as hierarchy
from statwalk.services.library.load import load
from statwalk.skin import _kernels as skin
from statwalk.skin.crowd import CrowdSkin
from statwalk.skin.deform import surface
from statwalk.skin.primitive import Primitive, Skin
from statwalk.solve.chains import SOLVERS
from statwalk.stage.stage import Stage
from statwalk.stage.steps.expression_values import expression_values

NEWER = ("ymm", "zmm", "vfmadd")
"""registers of 256 and 512 bits, and FMA, in the text of machine code"""
CHANCE = np.random.default_rng(17)
CASES = []


def case(function):
    CASES.append(function)
    return function


def numbers(*shape):
    return CHANCE.normal(size=shape).astype(np.float32)


def rotations(*shape):
    values = numbers(*shape, 4)
    return values / np.sqrt((values * values).sum(-1, keepdims=True))


@case
def skinned():
    """Parts of one to eight influences, with morph targets; one of them overflows, and is repaired."""
    bones = numbers(6, 3, 4)
    skin = Skin("skin", np.arange(6, dtype=np.int32), numbers(6, 3, 4))
    parts = [soft(count, influences) for count, influences in ((16, 1), (130, 4), (45, 8))]
    whole = surface(parts, [skin])
    out = [np.zeros((2, whole.positions.size), np.float32) for _ in range(2)]
    limits = [np.zeros((3, 6), np.float32) for _ in range(2)]
    for scale, flat, bounds in zip((1, 1e37), out, limits, strict=True):
        whole.pose_into(bones * np.float32(scale), numbers(2), flat[0], flat[1], bounds)
    return *out, *limits


@case
def skinned_by_dual_quaternions():
    """Bones that stretch, bones that only turn, and bones that overflow."""
    parts = [soft(count, influences) for count, influences in ((16, 1), (130, 4), (45, 8))]
    bind = np.tile(np.eye(4, dtype=np.float32)[:3], (6, 1, 1))
    whole = surface(parts, [Skin("skin", np.arange(6, dtype=np.int32), bind)], is_dual=True)
    turned = np.concatenate([quat.to_matrix(rotations(6)), numbers(6, 3, 1)], axis=2)
    found = []
    for bones in (numbers(6, 3, 4), turned, numbers(6, 3, 4) * np.float32(1e37)):
        flat, limits = np.zeros((2, whole.positions.size), np.float32), np.zeros((3, 6), np.float32)
        whole.pose_into(bones, numbers(2), flat[0], flat[1], limits)
        found += [flat, limits]
    return found


@case
def skinned_crowd():
    """Nineteen actors, in a block that is full and one that is not."""
    parts = [soft(count, influences) for count, influences in ((16, 1), (130, 4), (45, 8))]
    skin = CrowdSkin(surface(parts, [Skin("skin", np.arange(6, dtype=np.int32), numbers(6, 3, 4))]))
    out = skin.room(19)
    skin.pose(numbers(19, 6, 3, 4), np.zeros((19, 2), np.float32), out)
    return [out]


def soft(vertices, influences):
    joints = CHANCE.integers(0, 6, (vertices, influences)).astype(np.uint16)
    weights = np.full((vertices, influences), 1 / influences, np.float32)
    targets = numbers(2, vertices, 3)
    return Primitive(
        0,
        0,
        0,
        0,
        numbers(vertices, 3),
        numbers(vertices, 3),
        None,
        4,
        None,
        0,
        joints,
        weights,
        targets,
        targets,
    )


@case
def placed():
    out = np.zeros((3, 5, 3, 4), np.float32)
    local = numbers(3, 5, 3), rotations(3, 5), numbers(3, 5, 3)
    hierarchy.world(np.array([-1, 0, 1, 1, 3], np.int32), *local, out)
    hierarchy.place(numbers(3, 3, 4), out)
    return (out,)


@case
def inbetween():
    out = np.zeros(1003, np.float32)
    skin.inbetween(numbers(1003), numbers(1003), 0.3, out)
    return (out,)


@case
def segments():
    rows = [np.zeros((20, 2 * width), np.float32) for width in (3, 4, 1)]
    ends = np.array([3, 4, 20])
    keys.turns(numbers(20, 4), ends, rows[1])
    keys.lines(numbers(20, 3), ends, rows[0])
    keys.lines(numbers(20, 1), ends, rows[2])
    return tuple(rows)


@case
def looked_at():
    vectors, weights = rotations(77)[:, :3], np.full((33, 4), 0.25, np.float32)
    found = (
        reading.unit_length(vectors.copy(), np.float32(0.5)),
        skin.normalised(weights, np.float32(1e-6)),
    )
    return (np.array([*found, reading.within(weights.ravel(), np.float32(0), np.float32(0.3))]),)


@case
def sampled():
    """Every kind of keys, alone and blended, in lanes that are full and that are not; pace and root
    motion.
    """
    rows = [
        random_motions.blocks(
            tables_of(random_motions.motions(even), random_motions.REST), *random_motions.crowd()
        )
        for even in (0, 1)
    ]
    start, end, speeds = np.linspace(0, 0.9, 40), np.linspace(0.9, 0.1, 40), np.linspace(0, 5, 40)[:, None]
    walk = random_motions.walks()[0]
    rates, ways = (
        walk.rate(start, np.full(40, 1 / 60), speeds),
        walk.way(start, end, np.arange(40) % 3, speeds),
    )
    return *(buffer.values for buffer in rows), rates, ways, walk.pose(start, speeds).rotation


@case
def ticks():
    """Wild machines with layers, blends, senses and travel, twenty actors: every step of the tick, poses,
    places and hashes.
    """
    found = []
    for seed in (0, 3):
        stage = Stage(seed=seed)
        stage.add_many(
            role_of(wild_machines.machine(seed)), [((place / 2, 0, 0), place) for place in range(20)]
        )
        for told in wild_machines.inputs(seed, 90, 20).values():
            for kind, actor, name, value in told:
                with suppress(StageError):  # travel: there may be no way
                    getattr(stage, "send" if kind == "press" else kind)(
                        actor, name, *([value] if kind == "set" else [])
                    )
            stage.step()
        (cast,) = stage.casts
        found += [cast.shown.rows(), cast.position, cast.heading, cast.hash]
    return found


@case
def expressed():
    """The gearbox: expressions in the tick, and the values of their variables."""
    stage = Stage(seed=1)
    stage.add_many(load("gearbox"), [((place, 0, 0), 0) for place in range(20)])
    stage.step(40)
    (cast,) = stage.casts
    return cast.shown.rows(), cast.hash, expression_values(cast, np.arange(20), 40, 1 / 60)


@case
def hung():
    """The ship's chain, hanging, dragged, let go and moored, twenty actors."""
    stage = Stage(seed=1)
    actors = stage.add_many(load("anchor-chain"), [((place, 0, 0), place) for place in range(20)])
    for number, actor in enumerate(actors):
        stage.set(actor, "anchor", (number + 0.9, 1.0 + 0.1 * number, 0.3))
        stage.set(actor, "held", number % 2)
    stage.step(25)
    for number, actor in enumerate(actors):
        stage.set(actor, "held", 0)
        if number % 3 == 0:
            stage.send(actor, "MOOR")
    stage.step(25)
    (cast,) = stage.casts
    return cast.shown.rows(), cast.solver_memory, cast.hash


@case
def pulled():
    """Tentacles on the way to their targets and back to their sway, with half of the weight and with all."""
    stage = Stage(seed=1)
    actors = stage.add_many(load("tentacle"), [((place, 0, 0), place) for place in range(20)])
    for number, actor in enumerate(actors):
        stage.set(actor, "target", (number + 0.5, 0.2 + 0.1 * number, 0.4))
        stage.set(actor, "pull", 0.5 + number % 2 / 2)
        stage.set(actor, "middle_bend", 6.0 * number)
        stage.send(actor, "INVERSE" if number % 5 else "MIDDLE")
    stage.step(30)
    for actor in actors[::3]:
        stage.send(actor, "INVERSE")
    stage.step(20)
    (cast,) = stage.casts
    return cast.shown.rows(), cast.solver_memory, cast.hash


@case
def walked():
    """Walkers with locked feet, springs and gazes, on the way from state to state."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(shutil.copytree(MACHINES / "faq-walker", Path(temporary) / "walker"))
        with (folder / "machine.yaml").open("a") as file:
            file.write("springs: {Left.lowerarm: {half_life: 0.1, frequency: 2}, Head: {half_life: 0.2}}\n")
        role = load(folder)
    stage = Stage(seed=2)
    walkers = stage.add_many(role, [((place, 0, 0), place) for place in range(20)])
    for place, walker in enumerate(walkers):
        stage.set(walker, "look", place / 19)
        stage.set(walker, "gaze", (place, 1.5 + place / 20, 3))
    for tick in range(90):
        for walker in walkers[tick % 7 :: 7]:
            (stage.hold if tick % 40 < 25 else stage.release)(walker, "FORWARD")
        stage.step()
    (cast,) = stage.casts
    return cast.shown.rows(), cast.position, cast.solver_memory, cast.hash


@case
def climbed():
    """Walkers on stairs and a slope, from all sides."""
    stage, role = Stage(seed=3), load(MACHINES / "terrain")
    for walker in stage.add_many(role, [((0.2 * k - 1.6, 0, 0.5 * k), 0.7 * k) for k in range(17)]):
        stage.hold(walker, "FORWARD")
    stage.step(150)
    (cast,) = stage.casts
    return cast.shown.rows(), cast.position, cast.solver_memory, cast.hash


@case
def solved():
    """Every solver, free and with every kind of limit, in lanes that are full and that are not."""
    cone = JointLimit(CONE, twist=(-0.4, 0.4), swing=((-0.5, 0.5), (-0.3, 0.3)))
    limits = {
        1: cone,
        2: JointLimit(EULER, angles=((-0.5, 0.5), (-1.0, 0.2), (-2.0, 2.5))),
        3: JointLimit(HINGE, twist=(-1.2, 0.2)),
        4: JointLimit(CONE, swing=((-0.6, 0.6), (-0.6, 0.6))),
        5: JointLimit(RANGE, twist=(-1.0, 0.5), swing=((-0.3, 0.6), (-0.2, 0.8))),
    }
    chain, limb = ik_chains.random_poses(40, 6, 3), ik_chains.random_poses(40, 3, 4)
    targets, found = CHANCE.normal(size=(40, 3)) * 2, []
    for solver in SOLVERS:
        poses = limb if solver == "two-bone" else chain
        joints = poses.rotation.shape[1] - 1
        few = {joint: limit for joint, limit in limits.items() if joint <= joints}
        sensitivity = () if solver == "two-bone" else (1.0, 0.5, 0.0, 1.0, 1.0, 1.0)
        for more in ({}, {"limits": few}, {"sensitivity": sensitivity, "softening": 0.2, "weight": 0.7}):
            after, outcome = ik_chains.solved(poses, targets, solver, pole=(0.3, 1, 0), pole_kind=1, **more)
            found += [after.rotation, outcome.distance, outcome.iterations]
    return found


def digest(arrays):
    state = hashlib.sha256()
    for array in arrays:
        state.update(np.ascontiguousarray(array).tobytes())
    return state.hexdigest()[:16]


def of_the_product():
    """Returns the kernels of the package in this process, without the kernels of tests."""
    return [made for made in compiling.KERNELS if (made.__module__ or "").startswith("statwalk.")]


def main():
    results = {function.__name__: digest(function()) for function in CASES}
    compiled = [made for made in of_the_product() if made.stats.cache_misses]
    # one kernel, as the compiler makes machine code once more to show it
    newer = newer_in(skin.inbetween) if skin.inbetween in compiled else []
    print(json.dumps({"digests": results, "compiled": [made.__name__ for made in compiled], "newer": newer}))


def newer_in(made):
    text = "".join(made.inspect_asm().values())
    return [name for name in NEWER if name in text]
