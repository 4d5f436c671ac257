"""The ground speed of motions on the spot: a tread whose speed is known, and the walker's walk without its
root motion.
"""

from dataclasses import replace

import numpy as np
import pytest
from paths import MACHINES
from statwalk.character.role import Role
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.services.library.load import load_role
from statwalk.stage.stage import Stage
from treads import tread_clip, trodden

WALK = tread_clip("walk", 1.0)
CHARACTER = trodden(WALK, tread_clip("run", 2.0), tread_clip("stand", 0.0, lift=0.0))


def role_of(fields, more="", character=CHARACTER):
    text = f"""character: c.glb
initial: GO
states: {{GO: {{{fields}, loop: true}}}}
table: |
  state | X
  GO    | -
{more}"""
    return Role.build("tread", character, read_machine(text, "tread"))


def velocity_of(fields, more="", seconds=3):
    """The mean velocity of an actor, x and z (m/s)."""
    stage = Stage(seed=1)
    actor = stage.add(role_of(fields, more))
    stage.step(60 * seconds)
    return actor.root.position[[0, 2]] / seconds


@pytest.mark.parametrize(
    ("fields", "velocity"),
    [
        ("motion: walk", (0, 0)),
        ("motion: walk, ground_speed: found", (0, 1)),
        ("motion: run, ground_speed: found, speed: 0.5", (0, 1)),
        ("motion: walk, ground_speed: -1.5", (0, -1.5)),
        ("motion: stand, ground_speed: [0.5, 2]", (0.5, 2)),
    ],
)
def test_the_actor_moves_as_fast_as_the_ground_runs(fields, velocity):
    assert velocity_of(fields) == pytest.approx(velocity, abs=0.02)


@pytest.mark.parametrize(("pace", "speed"), [(1, 1), (1.5, 1.5), (2, 2)])
def test_each_clip_of_a_blend_has_its_own(pace, speed):
    motion = "motion: {over: pace, clips: {walk: 1, run: 2}}, ground_speed: found"
    more = f"parameters: {{pace: {{default: {pace}, min: 1, max: 2}}}}\n"
    assert velocity_of(motion, more) == pytest.approx((0, speed), abs=0.03)


def test_a_clip_of_one_pose_in_a_blend_goes_nowhere():
    pose = replace(tread_clip("pose", 1.0), duration=0.0, channels=())
    motion = "motion: {over: pace, clips: {pose: 1, walk: 2}}, ground_speed: 1.5"
    role = role_of(motion, "parameters: {pace: {default: 1, min: 1, max: 2}}\n", trodden(pose, WALK))
    stage = Stage(seed=1)
    actor = stage.add(role)
    stage.step(60)
    assert np.isfinite(actor.world).all()
    assert actor.root.position[2] == 0


def test_the_foot_that_treads_stands_in_the_world():
    stage = Stage(seed=1)
    actor = stage.add(role_of("motion: walk, ground_speed: found"))
    places = []
    for _ in range(30):
        stage.step(1)
        places.append(actor.world[2, :, 3])
    assert np.ptp(places, axis=0) == pytest.approx(0, abs=0.01)


def test_a_walk_without_its_root_motion_gets_it_back():
    """The truth is the root motion of the walker's own clip, which the test takes away."""
    walker = load_role(MACHINES / "faq-walker")
    walk = walker.motions[walker.state("WALK")]
    in_place = replace(walker.character, clips={"walk": replace(walk.clip, name="walk")})
    (member,) = role_of("motion: walk, ground_speed: found", character=in_place).motions
    truth = np.diff(walk.root.places[[0, -1]], axis=0)[0, :2] / walk.clip.duration
    assert member.ground_speed == pytest.approx(truth, abs=0.02)


def test_feet_of_a_motion_that_moves_its_actor_are_planted():
    legs = role_of("motion: walk, ground_speed: found", "foot_lock: true\n").solvers.legs
    assert legs.span[0] == pytest.approx((0, 0.6), abs=0.03)


def test_feet_that_run_back_cannot_be_held():
    assert not role_of("motion: walk", "foot_lock: true\n").solvers.legs.span.size


@pytest.mark.parametrize(
    ("fields", "reason"),
    [
        (
            "motion: stand, ground_speed: found",
            "the ground runs under no foot of stand; write metres",
        ),
        ('motion: {expressions: ""}, ground_speed: 1', "the motion needs a clip that lasts"),
    ],
)
def test_what_cannot_be_is_refused_with_the_line(fields, reason):
    with pytest.raises(MachineError, match=rf"line 3: ground_speed: {reason}"):
        role_of(fields)


def test_a_layer_moves_no_actor():
    layer = "layers: {up: {initial: A, states: {A: {motion: walk, loop: true, ground_speed: 1}}}}\n"
    with pytest.raises(MachineError, match=r"line 7: ground_speed: the states of a layer move no actor"):
        role_of("motion: stand", layer)
