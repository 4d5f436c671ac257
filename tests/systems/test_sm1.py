"""SM1: the eleven states of FAQ Q19, each tied to a motion of its own that the character has."""

from statwalk.services.library.load import load

# From the list in FAQ Q19.
STATES = {
    "STAT": "stand",
    "STWK": "start-walk",
    "CSTP": "come-to-stop",
    "WALK": "walk",
    "TLFT": "turn-left",
    "TRGT": "turn-right",
    "JUMP": "jump",
    "FLY": "fly",
    "LAND": "land",
    "CRCH": "crouch",
    "STUP": "stand-up",
}


def test_every_state_has_its_motion():
    role = load("faq-walker")
    machine = role.machine
    assert {name: machine.motions[machine.motion[row]] for row, name in enumerate(machine.states)} == STATES


def test_every_motion_takes_time():
    role = load("faq-walker")
    assert all(role.character.clips[motion].duration > 0 for motion in STATES.values())
