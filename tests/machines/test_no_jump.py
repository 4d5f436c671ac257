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
from statwalk.services.library.load import load_role
from statwalk.stage.measure.alone import motion_alone
from statwalk.stage.measure.jump import jump_of
from statwalk.stage.measure.subject import Subject
from statwalk.stage.measure.trials import placed
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
TRANSITIONS = [
    (state, event, MACHINE.states[MACHINE.target[row, column]])
    for row, state in enumerate(MACHINE.states)
    for column, event in enumerate(MACHINE.events[:-1])
    if state in PATHS and MACHINE.target[row, column] >= 0 and MACHINE.when[row, column] == 0
]
CHANGES = [(state, event, to) for state, event, to in TRANSITIONS if state != to]


SUBJECT = Subject(WALKER)
MOST = {name: SUBJECT.most(row) for row, name in enumerate(MACHINE.states)}
NAMES = SUBJECT.names


def joints_on_stage(frame):
    """(N, J, 3) where the joints of N actors are."""
    world = WALKER.character.world(frame.pose)[..., :3, 3][:, SUBJECT.joints].astype(float)
    return placed(world, frame.root_position, frame.heading)


def play(cases):
    """Plays (state, event, phase, ticks until a second event or None, that event) side by side: when each was
    sent, tracks (T, J, 3).
    """
    stage = Stage()
    actors = [stage.add(WALKER) for _ in cases]
    sent, paths, tracks = [0] * len(cases), [list(PATHS[case[0]]) for case in cases], []
    for tick in range(600):
        frame = stage.frame.casts[0]
        tracks.append(joints_on_stage(frame))
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


def jump(track, states):
    """The jump of a track through motions."""
    return jump_of(track, [MOST[state] for state in states], NAMES)


@pytest.mark.parametrize("phase", PHASES)
@pytest.mark.parametrize(("state", "event", "to"), CHANGES)
def test_nothing_jumps_in_a_transition(played, state, event, to, phase):
    sent, track = played[state, event, phase, None, None]
    assert sent, f"{state} never reached this phase"
    seen = track[sent - 2 : sent + ticks_of(state, event) + 3]
    assert jump(seen, (state, to)).body <= ROOM_OF_THE_BODY
    assert jump(seen, (state, to)).joint <= ROOM_OF_A_JOINT, jump(seen, (state, to))


@pytest.mark.parametrize("later", LATER)
@pytest.mark.parametrize(("state", "event", "to", "second", "last"), INTERRUPTIONS)
def test_nothing_jumps_when_a_transition_is_interrupted(played, state, event, to, second, last, later):
    for phase in PHASES:
        sent, track = played[state, event, phase, later, second]
        seen = track[sent - 2 : sent + later + ticks_of(to, second) + 3]
        seen_jump = jump(seen, (state, to, last))
        assert seen_jump.body <= ROOM_OF_THE_BODY
        assert seen_jump.joint <= ROOM_OF_A_JOINT, seen_jump


def test_a_cut_would_be_noticed():
    """The same measure over a cut from the middle of a stride to standing."""
    walk, stand = (
        motion_alone(WALKER, MACHINE.states.index(name), 0.0)[:, SUBJECT.joints] for name in ("WALK", "STAT")
    )
    cut = np.concatenate([walk[:30] - walk[29, 0] * [1, 0, 1], stand[:5] - stand[0, 0] * [1, 0, 1]])
    assert jump(cut, ("WALK", "STAT")).body > 10
    assert jump(cut, ("WALK", "STAT")).joint > 10
