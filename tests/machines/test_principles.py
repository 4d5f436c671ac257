"""The machine `principles`: beside each plain motion of the grey box the orange one has a principle."""

import numpy as np
import pytest
import statwalk
from closed_volume import volume
from scipy.spatial.transform import Rotation
from statwalk.character.made_clips import sides_of
from statwalk.motion.principles.twinning import twinning

ROLE = statwalk.load("principles")
NAMES = list(ROLE.character.skeleton.names)
PLAIN, SHOWN = NAMES.index("Plain.body"), NAMES.index("Shown.body")
BODIES = {  # the largest part of each body: its box
    joint: max(
        (row for row, part in enumerate(ROLE.character.parts) if part.joint == joint),
        key=lambda row: np.ptp(ROLE.character.parts[row].positions, axis=0).prod(),
    )
    for joint in (PLAIN, SHOWN)
}


def played(event, ticks):
    """The actor after the event at tick 0, tick by tick."""
    stage = statwalk.Stage(seed=1)
    actor = stage.add(ROLE)
    stage.send(actor, event)
    for _ in range(ticks):
        stage.step(1)
        yield actor


def volume_of(parts, joint):
    return volume(parts[BODIES[joint]].positions, ROLE.character.parts[BODIES[joint]].indices)


def ways(event):
    """The x (250,) of both bodies, tick by tick."""
    return np.array([actor.pose.translation[[PLAIN, SHOWN], 0] for actor in played(event, 250)]).T


def test_the_squashed_box_keeps_its_volume():
    rest = volume_of(ROLE.character.vertices(ROLE.character.bind_pose), SHOWN)
    clip, heights = ROLE.character.clip("hop-soft"), []
    for time in np.linspace(0, 1, 241):
        parts = ROLE.character.vertices(clip.sample(time))
        assert volume_of(parts, SHOWN) == pytest.approx(rest, rel=1e-6)
        heights.append(np.ptp(parts[BODIES[SHOWN]].positions[:, 1]))
    for tick, actor in enumerate(played("SQUASH", 100)):
        if tick > 20:  # the blend into it is over
            assert volume_of(actor.vertices(), SHOWN) == pytest.approx(rest, rel=1e-6)
    assert min(heights) < 0.65 * heights[0]
    assert max(heights) > 1.2 * heights[0]


def test_the_grey_box_is_as_keyed():
    clip = ROLE.character.clip("hop")
    for tick, actor in enumerate(played("SQUASH", 90)):
        if tick > 20:  # the blend is over
            expected = clip.sample(actor.time)
            np.testing.assert_allclose(actor.pose.translation[PLAIN], expected.translation[PLAIN], atol=2e-6)
            np.testing.assert_array_equal(actor.pose.scale[PLAIN], 1)


def test_anticipation_goes_back_first():
    plain, shown = ways("ANTICIPATE")
    begin = 144  # the third run from left to right, long after the blend
    third = slice(begin, begin + 36)
    assert plain[third].min() >= -0.3201
    assert shown[third].min() < -0.32 - 0.2 * 0.64
    assert plain[begin + 71] == pytest.approx(shown[begin + 71], abs=1e-4)


def test_slow_in_slow_out_keeps_ends_and_changes_speed():
    plain, shown = ways("EASE")
    there = slice(145, 214)
    speed = np.abs(np.diff(plain[there])), np.abs(np.diff(shown[there]))
    assert np.ptp(speed[0]) < 0.01 * speed[0].mean()
    assert max(speed[1][0], speed[1][-1]) < 0.05 * speed[1].max()
    assert np.abs(plain[180] - shown[180]) < 0.03


def test_the_antenna_on_springs_lags_swings_past_and_settles():
    tips = [NAMES.index(f"{who}.antenna.tip") for who in ("Plain", "Shown")]
    worlds = np.array([actor.world[:, 0, 3] for actor in played("FOLLOW", 216)])
    lean = worlds[:, tips] - worlds[:, [PLAIN, SHOWN]]
    assert np.abs(lean[30:, 0]).max() < 1e-5  # the grey one's is stiff
    dash = lean[146:212, 1]
    assert dash.min() < -0.05  # it lags behind the dash to +X …
    assert dash.max() > 0.02  # … and swings past
    assert np.abs(dash[-5:]).max() < 0.02  # … and comes to rest


def test_arcs_have_no_corners_and_no_seam():
    path = ROLE.character.clip("round")
    moments = np.arange(0, 288) / 120  # two and a half seconds less one
    both = [
        clip.sample(moments, loop=True).translation[:, SHOWN]
        for clip in (ROLE.character.clip("zigzag"), path)
    ]
    around = [np.concatenate([way, way[:2]]) for way in both]  # over the seam
    corner, soft = (np.linalg.norm(np.diff(way, 2, axis=0), axis=-1).max() for way in around)
    assert soft < 0.15 * corner
    assert np.abs(both[0] - both[1]).max() < 0.15


def test_the_mirrored_greeting_raises_the_other_arm():
    left, right = NAMES.index("Shown.arm.L"), NAMES.index("Shown.arm.R")
    plain, mirrored = (ROLE.character.clip(name).sample(1.0) for name in ("greet", "greet-mirrored"))
    swings = [
        Rotation.from_quat(pose.rotation[[left, right, SHOWN]]).as_rotvec() for pose in (plain, mirrored)
    ]
    np.testing.assert_allclose(swings[1][:2], swings[0][[1, 0]] * [1, -1, -1], atol=1e-5)
    np.testing.assert_allclose(swings[1][2], -swings[0][2], atol=1e-5)


def test_the_report_calls_the_clap_twinned_and_the_arms_apart_not():
    sides = sides_of(ROLE.character)
    alike = {
        name: {twin.left: twin for twin in twinning(ROLE.character.clip(name), sides)}["Shown.arm.L"]
        for name in ("clap", "clap-apart")
    }
    assert alike["clap"].is_twinned
    assert not alike["clap-apart"].is_twinned


def test_every_event_shows_a_difference_between_the_boxes():
    shown = [row for row, name in enumerate(NAMES) if name.startswith("Shown.")]
    plain = [NAMES.index(NAMES[row].replace("Shown", "Plain")) for row in shown]
    for event in ROLE.machine.events[:-1]:
        most = max(
            np.abs(actor.world[shown, :3, 3] - actor.world[plain, :3, 3] - [1.4, 0, 0]).max()
            for actor in played(event, 150)
        )
        assert most > (0.0 if event == "STAND" else 0.03), event


def test_straight_ahead_one_motion_leads_on_to_the_next():
    states = [actor.states[1] for actor in played("AHEAD", 420)]
    order = [name for name, before in zip(states, [None, *states], strict=False) if name != before]
    assert order[:4] == ["AHEAD-1", "AHEAD-2", "AHEAD-3", "AHEAD-1"]
