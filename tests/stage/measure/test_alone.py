"""A motion by itself goes as it goes on a stage."""

import numpy as np
import pytest
from paths import MACHINES
from statwalk.services.library.load import load_role
from statwalk.stage.measure.alone import entries_of, motion_alone

WALKER = load_role(MACHINES / "faq-walker")


def test_a_blend_by_itself_goes_at_the_pace_of_its_clip():
    """CRCH after a landing is the clip `absorb`: 5 ticks, where `crouch` takes 27."""
    row = WALKER.machine.states.index("CRCH")
    for axes, clip in zip(entries_of(WALKER, row), WALKER.motions[row].motions, strict=True):
        seconds = clip.clip.duration
        for offset in (0.0, 0.01):
            track = motion_alone(WALKER, row, offset, axes)
            poses = WALKER.character.clips[clip.clip.name].sample(offset + np.arange(len(track)) / 60)
            heights = WALKER.character.world(poses)[:, 0, 1, 3]
            assert len(track) == pytest.approx((seconds - offset) * 60, abs=1)
            assert track[:, 0, 1] == pytest.approx(heights, abs=1e-5)
