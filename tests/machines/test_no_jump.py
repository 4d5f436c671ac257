"""No jump (SM4): through every transition of faq-walker, seen on the stage, from ten phases of the old motion
and through interruptions, nothing changes its position or velocity more from tick to tick than it does within
the motions themselves.

Two measures. The body: the joint that changes most in the transition, against the one that changes most in
either motion. Each joint by itself: what is shown is the sum of the new motion and of what is left of the old
one, so a joint that is at its liveliest in both at that moment passes the most of either. A cut passes it
more than tenfold. The rooms are what was measured, rounded up.
"""

import numpy as np
import pytest
from paths import MACHINES
from statwalk.maths import quat, transform
from statwalk.motion.root import compose
from statwalk.services.library.load import load_role
from statwalk.stage.stage import Stage

ROOM_OF_THE_BODY = 1.2
ROOM_OF_A_JOINT = 2.4
PHASES = np.linspace(0, 0.9, 10)
PATHS = {
    "STAT": (),
    "STWK": ("FORWARD",),
    "WALK": ("FORWARD",),
    "CSTP": ("FORWARD", "STOP"),
    "TLFT": ("LEFT",),
    "TRGT": ("RIGHT",),
}
WALKER = load_role(MACHINES / "faq-walker")
MACHINE = WALKER.machine
JOINTS = [
    row for row, name in enumerate(WALKER.character.skeleton.names) if name != "Body"
]  # the node that carries the mesh is no joint
TRANSITIONS = [
    (state, event, MACHINE.states[MACHINE.target[row, column]])
    for row, state in enumerate(MACHINE.states)
    for column, event in enumerate(MACHINE.events[:-1])
    if state in PATHS and MACHINE.target[row, column] >= 0 and MACHINE.when[row, column] == 0
]
CHANGES = [(state, event, to) for state, event, to in TRANSITIONS if state != to]


def joints_on_stage(pose, position, heading):
    """(N, J, 3) where the joints of N actors are."""
    actor = transform.from_trs(position, quat.from_axis_angle(np.array([0.0, 1, 0]), heading), np.ones(3))
    return transform.apply(actor[:, None], WALKER.character.world(pose)[..., :3, 3][:, JOINTS].astype(float))


def motion_on_stage(state, offset):
    """(T, J, 3): a motion by itself, a tick at a time from `offset` seconds on; those that loop run twice."""
    motion, loops = WALKER.motions[state], bool(MACHINE.loop[state])
    clip = motion.clip
    times = np.arange(offset, clip.duration * (1 + loops), 1 / 60)
    wrapped = np.mod(times, clip.duration) if loops else times
    place = np.zeros((len(times), 3))
    for k in range(1, len(times)):
        wraps = np.array([int(wrapped[k] < wrapped[k - 1])])
        place[k] = compose(
            place[k - 1 : k], motion.way(wrapped[k - 1 : k], wrapped[k : k + 1], wraps, np.zeros((1, 0)))
        )[0]
    position = np.stack([place[:, 0], 0 * place[:, 0], place[:, 1]], -1)
    return joints_on_stage(clip.sample(wrapped), position, place[:, 2])


def changes_of(track):
    """The largest change of position and of velocity (J,) from tick to tick in a track (T, J, 3)."""
    return [np.linalg.norm(np.diff(track, order, axis=0), axis=-1).max(0) for order in (1, 2)]


MOST = {
    name: np.max(
        [changes_of(motion_on_stage(row, offset)) for offset in np.linspace(0, 1 / 60, 4, endpoint=False)], 0
    )
    for row, name in enumerate(MACHINE.states)
}


def play(cases):
    """Plays (state, event, phase, ticks until a second event or None, that event) side by side: when each was
    sent, tracks (T, J, 3).
    """
    stage = Stage()
    actors = [stage.add(WALKER) for _ in cases]
    sent, paths, tracks = [0] * len(cases), [list(PATHS[case[0]]) for case in cases], []
    for tick in range(600):
        frame = stage.frame.casts[0]
        tracks.append(joints_on_stage(frame.pose, frame.root_position, frame.heading))
        for k, (state, event, phase, later, second) in enumerate(cases):
            here, is_settled = MACHINE.states[frame.state[k, 0]], frame.blend[k, 0] == 0 and tick > 5
            if sent[k]:
                if later is not None and tick == sent[k] + later:
                    stage.send(actors[k], second)
            elif here == state and frame.phase[k, 0] >= phase and is_settled:
                stage.send(actors[k], event)
                sent[k] = tick
            elif paths[k] and here in ("STAT", "WALK") and tick > 5 and here != state:
                stage.send(actors[k], paths[k].pop(0))
                paths[k] = paths[k] if here == "WALK" or len(PATHS[state]) > 1 else []
        stage.step()
    return sent, np.stack(tracks, 1)


def ticks_of(state, event):
    (alternative,) = MACHINE.alternatives[MACHINE.states.index(state), MACHINE.events.index(event)]
    return round(alternative.blend * 60)


INTERRUPTIONS = [
    ("STAT", "LEFT", "TLFT", "RIGHT", "TRGT"),
    ("STAT", "FORWARD", "STWK", "STOP", "CSTP"),
    ("WALK", "LEFT", "TLFT", "STOP", "CSTP"),
    ("WALK", "RIGHT", "TRGT", "LEFT", "TLFT"),
]
LATER = (1, 5, 11)


@pytest.fixture(scope="module")
def played():
    plain = [(state, event, phase, None, None) for state, event, _ in CHANGES for phase in PHASES]
    twice = [
        (state, event, phase, later, second)
        for state, event, _, second, _ in INTERRUPTIONS
        for phase in PHASES
        for later in LATER
    ]
    return dict(zip(plain + twice, zip(*play(plain + twice), strict=True), strict=True))


def of_the_body(track, states):
    """How far a track passes the motions of `states`: the liveliest joint against the liveliest joint."""
    most = np.max([MOST[state] for state in states], 0).max(1)
    return float((np.array(changes_of(track)).max(1) / most).max())


def of_a_joint(track, states):
    """By how much, and in which joint, a track passes the motions of `states`; a joint that stands still in
    all counts from 0.1 mm.
    """
    ratios = np.array(changes_of(track)) / (np.max([MOST[state] for state in states], 0) + 1e-4)
    what, joint = np.unravel_index(ratios.argmax(), ratios.shape)
    return float(ratios.max()), ("position", "velocity")[what], WALKER.character.skeleton.names[JOINTS[joint]]


@pytest.mark.parametrize("phase", PHASES)
@pytest.mark.parametrize(("state", "event", "to"), CHANGES)
def test_nothing_jumps_in_a_transition(played, state, event, to, phase):
    sent, track = played[state, event, phase, None, None]
    assert sent, f"{state} never reached this phase"
    seen = track[sent - 2 : sent + ticks_of(state, event) + 3]
    assert of_the_body(seen, (state, to)) <= ROOM_OF_THE_BODY
    assert of_a_joint(seen, (state, to)) <= (ROOM_OF_A_JOINT,)


@pytest.mark.parametrize("later", LATER)
@pytest.mark.parametrize(("state", "event", "to", "second", "last"), INTERRUPTIONS)
def test_nothing_jumps_when_a_transition_is_interrupted(played, state, event, to, second, last, later):
    for phase in PHASES:
        sent, track = played[state, event, phase, later, second]
        seen = track[sent - 2 : sent + later + ticks_of(to, second) + 3]
        assert of_the_body(seen, (state, to, last)) <= ROOM_OF_THE_BODY
        assert of_a_joint(seen, (state, to, last)) <= (ROOM_OF_A_JOINT,)


def test_a_cut_would_be_noticed():
    """The same measure over a cut from the middle of a stride to standing."""
    walk, stand = (motion_on_stage(MACHINE.states.index(name), 0.0) for name in ("WALK", "STAT"))
    cut = np.concatenate([walk[:30] - walk[29, 0] * [1, 0, 1], stand[:5] - stand[0, 0] * [1, 0, 1]])
    assert of_the_body(cut, ("WALK", "STAT")) > 10
    assert of_a_joint(cut, ("WALK", "STAT")) > (10,)
