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
    """A motion, or a blend of its kind: `come-to-stop-left-1` is a come-to-stop."""
    states = load("faq-walker").definition.states
    assert states.keys() == STATES.keys()
    for name, motion in STATES.items():
        assert any(clip.startswith(motion) for clip in states[name].clips)


def test_every_motion_takes_time():
    role = load("faq-walker")
    clips = {clip for state in role.definition.states.values() for clip in state.clips}
    assert all(role.character.clips[clip].duration > 0 for clip in clips)
