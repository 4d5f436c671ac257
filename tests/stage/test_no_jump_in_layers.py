"""Nothing jumps, in position or velocity, whichever layers turn, fade or are edited, and when a smooth
parameter of a blend is set.
"""

from itertools import pairwise

import gaits
import numpy as np
import pytest
import slow_inertialize
from statwalk.stage.stage import Stage


def press(*names):
    return [(name, None) for name in names]


SCRIPTS = {
    "an upper layer turns": {0.5: press("WAVE"), 1.5: press("REST")},
    "two layers turn at once": {0.5: press("BOTH"), 1.5: press("BOTH")},
    "one turns while another fades": {
        0.5: press("GO"),
        0.6: press("WAVE"),
        0.65: press("NOD"),
        0.75: press("REST"),
        1.5: press("STOP"),
    },
    "the base turns while an upper one fades": {
        0.5: press("NOD"),
        0.6: press("GO"),
        0.7: press("STOP"),
        0.75: press("CALM"),
    },
    "one is interrupted": {0.5: press("WAVE"), 0.6: press("REST"), 0.65: press("WAVE"), 0.75: press("BOTH")},
    "the speed of a blend is set": {0.3: press("GO"), 1.0: [("speed", 4.0)], 1.4: [("speed", 1.2)]},
}
EVEN = ("right: 0.62", "right: 0.7")
"""markers as far apart in both clips: between others, time goes on at another pace"""
ROLES = {
    "cubic": (EVEN,),
    "quintic": (EVEN, ("{blend: 0.2, buffer: 0}", "{blend: {seconds: 0.2, curve: quintic}, buffer: 0}")),
    "cut": (EVEN, ("{blend: 0.2, buffer: 0}", "{blend: 0, buffer: 0}")),
    "not smooth": (EVEN, ("max: 5, smooth: 0.3", "max: 5")),
}


def changes_of_velocity(rate, changes):
    """For each script: by how much the velocity of what is shown changes from tick to tick, at the most."""
    stage = Stage(rate=rate)
    actors = [stage.add(gaits.role(*changes)) for _ in SCRIPTS]
    poses = []
    for tick in range(int(2.2 * rate)):
        for actor, script in zip(actors, SCRIPTS.values(), strict=True):
            for what, value in script.get(tick / rate, ()):
                stage.set(actor, what, value) if value is not None else stage.send(actor, what)
        stage.step()
        poses.append(stage.frame.casts[0].pose)
    velocity = (
        np.array(
            [slow_inertialize.difference(later, earlier) for earlier, later in pairwise(poses)], np.float64
        )
        * rate
    )
    return np.abs(np.diff(velocity, axis=0)).max((0, 2))


@pytest.fixture(scope="module")
def ratio():
    """By role and script: the change of velocity in a tick of a quarter against that in a whole one."""
    found = {
        name: changes_of_velocity(240, changes) / changes_of_velocity(60, changes)
        for name, changes in ROLES.items()
    }
    return {name: dict(zip(SCRIPTS, row, strict=True)) for name, row in found.items()}


@pytest.mark.parametrize("curve", ["cubic", "quintic"])
@pytest.mark.parametrize("script", SCRIPTS)
def test_nothing_jumps(ratio, script, curve):
    """Where position and velocity go on, a quarter of a tick changes the velocity by about a quarter; a jump
    would be the same.
    """
    assert ratio[curve][script] < 0.45


def test_a_cut_is_seen_by_that_measure(ratio):
    assert ratio["cut"]["an upper layer turns"] > 0.9


def test_a_blend_without_smooth_jumps(ratio):
    assert ratio["not smooth"]["the speed of a blend is set"] > 0.9


@pytest.mark.parametrize(
    "change",
    [
        ("  head:", "  skull:"),
        ("mask: [chest]", "mask: [arm]"),
        ("  arm:\n    mask: [arm]", "  arm:\n    mask: [hand]"),
    ],
)
def test_an_edit_of_the_layers_does_not_jump(change):
    """Layers that are renamed, or move other joints, while they fade: a tick before, in it and after, the
    velocity changes little.

    A cut would change it by more than a radian a tick.
    """
    stage = Stage()
    actor = stage.add(gaits.role())
    for events in (["WAVE"], ["NOD"]):
        for event in events:
            stage.send(actor, event)
        stage.step(5)
    poses = [stage.frame.casts[0].pose]
    stage.edit(gaits.role(change))
    for _ in range(3):
        stage.step()
        poses.append(stage.frame.casts[0].pose)
    steps = np.array([slow_inertialize.difference(later, earlier) for earlier, later in pairwise(poses)])
    assert np.abs(np.diff(steps, axis=0)).max() < 0.12
