"""Springs in a tick against the equation of motion, with SciPy's matrix exponential in stage space."""

import numpy as np
import pytest
from playing import text_of
from scipy.linalg import expm
from scipy.spatial.transform import Rotation
from statwalk.character.character import Character
from statwalk.character.role import Role
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.maths.pose import rest
from statwalk.motion.clip import Channel, Clip
from statwalk.rig.skeleton import Skeleton
from statwalk.stage.stage import Stage

ARM, END = 2, np.array([0.3, 0, 0])
LOOP = "states:\n  HOP: {motion: hop, loop: true}\n", "state | GO\nHOP | -", "HOP"
CHANGES = (
    "states:\n  STAND: {motion: stand, loop: true}\n  HOP: {motion: hop}\n",
    "state | GO  | END\nSTAND | HOP | -\nHOP   |     | STAND",
    "STAND",
)


REST = rest(3)
REST.translation[:] = [[0, 1, 0], [0, 0.5, 0], [0.3, 0, 0]]
TIMES = np.linspace(0, 1, 61).astype(np.float32)


def clip(name: str, swing_deg: float, sway: float) -> Clip:
    """The chest turns to and fro about Z, so that the arm's ends go up and down; the hips sway."""
    phase = np.sin(2 * np.pi * TIMES)
    turns = Rotation.from_euler("z", swing_deg * phase[:, None], degrees=True).as_quat()
    places = np.stack([sway * phase, 1 + 0 * phase, 0.4 * TIMES], -1)
    channels = (
        Channel(0, "translation", TIMES, places.astype(np.float32)),
        Channel(1, "rotation", TIMES, turns.astype(np.float32)),
    )
    return Clip(name, channels, 1.0, REST)


SKELETON, _ = Skeleton.sorted(["hips", "chest", "arm"], [None, "hips", "chest"])
CLIPS = {one.name: one for one in (clip("hop", 50, 0.1), clip("stand", 5, 0.01))}
CHARACTER = Character("swinger", SKELETON, np.arange(3, dtype=np.int32), REST, CLIPS)


def stage_of(springs: str, rate: int, actors: int = 1, machine=LOOP):
    states, table, initial = machine
    stage = Stage(seed=1, rate=rate)
    role = Role.build("swinger", CHARACTER, read_machine(text_of(table, springs, states, initial)), "hips")
    return stage, [stage.add(role) for _ in range(actors)]


def played(springs: str, rate: int, ticks: int, actors: int = 1, machine=LOOP):
    """Start and far end (T, N, 3) of the arm's bone in the stage."""
    stage, everyone = stage_of(springs, rate, actors, machine)
    starts, ends = [], []
    for tick in range(ticks):
        if machine is CHANGES and tick % rate == rate // 2:
            stage.send(everyone[0], "GO")
        stage.step(1)
        worlds = [actor.world[ARM].astype(np.float64) for actor in everyone]
        starts.append([world[:3, 3] for world in worlds])
        ends.append([world[:3, :3] @ END + world[:3, 3] for world in worlds])
    return np.array(starts), np.array(ends)


def expected(rate: int, ticks: int, half_life: float, frequency: float, weight: float) -> np.ndarray:
    """The bone's directions (T, 3): its end on a spring at the place that the motion gives it."""
    starts, ends = played("", rate, ticks)
    starts, ends = starts[:, 0], ends[:, 0]
    decay, swing, dt = np.log(2) / half_life, 2 * np.pi * frequency, 1 / rate
    step = expm(np.array([[0, 1], [-(decay**2 + swing**2), -2 * decay]]) * dt)
    velocity = np.diff(ends, axis=0) * rate
    state, shown = np.zeros((2, 3)), [ends[0], ends[1]]
    for tick in range(2, ticks):
        state[1] -= velocity[tick - 1] - velocity[tick - 2]
        state = step @ state
        shrink = min(1, 0.9 * 0.3 / max(np.linalg.norm(state[0]), 1e-12))
        state = state * shrink
        shown.append(ends[tick] + weight * state[0])
    ways = np.array(shown) - starts
    return ways / np.linalg.norm(ways, axis=-1, keepdims=True)


@pytest.mark.parametrize(
    ("rate", "half_life", "frequency", "weight"),
    [(60, 0.1, 0, 1), (60, 0.2, 2, 1), (30, 0.15, 3, 0.5), (5, 0.001, 30, 1), (240, 1.0, 1, 1)],
)
def test_a_bone_follows_the_equation_of_its_spring(rate, half_life, frequency, weight):
    spring = f"springs: {{arm: {{half_life: {half_life}, frequency: {frequency}, weight: {weight}}}}}"
    ticks = 3 * rate
    starts, ends = played(spring, rate, ticks)
    ways = (ends - starts)[:, 0]
    np.testing.assert_allclose(np.linalg.norm(ways, axis=-1), 0.3, atol=1e-5)
    np.testing.assert_allclose(ways / 0.3, expected(rate, ticks, half_life, frequency, weight), atol=2e-3)


def test_a_spring_swings_visibly_and_settles():
    plain = np.diff(np.subtract(*played("", 60, 240))[:, 0], axis=0)
    starts, ends = played("springs: {arm: {half_life: 0.2, frequency: 2}}", 60, 240)
    loose = np.diff((starts - ends)[:, 0], axis=0)
    assert np.abs(loose - plain).max() > 0.01


@pytest.mark.parametrize("spring", ["{half_life: 0.2, frequency: 2}", "{half_life: 0.1}"])
def test_a_change_of_state_does_not_jump(spring):
    """The offset of a transition begins at the swung pose, and the spring goes on from there."""

    def jerk(text: str) -> float:
        starts, ends = played(text, 60, 240, 1, CHANGES)
        return float(np.linalg.norm(np.diff((ends - starts)[:, 0], 2, axis=0), axis=-1).max())

    assert jerk(f"springs: {{arm: {spring}}}") < 3 * jerk("")


def test_the_stiffest_spring_at_the_longest_step_stays_finite():
    starts, ends = played("springs: {chest: {half_life: 0.001, frequency: 30, below: true}}", 1, 60)
    assert np.isfinite(ends).all()
    assert np.linalg.norm(ends - starts, axis=-1).max() < 0.3001


def test_alone_and_in_a_crowd_the_bits_are_the_same():
    spring = "springs: {chest: {half_life: 0.1, frequency: 2, below: true}}"
    (_, alone), (_, crowd) = played(spring, 60, 120), played(spring, 60, 120, actors=19)
    np.testing.assert_array_equal(alone[:, 0], crowd[:, 0])


def test_a_past_tick_played_again_has_the_same_hash():
    stage, _ = stage_of("springs: {arm: {half_life: 0.5, frequency: 1}}", 60)
    stage.step(90)
    wanted = stage.hash
    stage.step(40)
    stage.seek(90)
    assert stage.hash == wanted


@pytest.mark.parametrize(
    ("spring", "words"),
    [
        ("{arn: {half_life: 1}}", "did you mean arm"),
        ("{arm: {}}", "`half_life` is missing"),
        ("{arm: {half_life: 0}}", "from 0.001 to 60"),
        ("{arm: {half_life: 1, stiffness: 3}}", "stiffness"),
    ],
)
def test_a_wrong_spring_is_refused_with_its_line(spring, words):
    with pytest.raises(MachineError, match=words):
        stage_of(f"springs: {spring}", 60)
