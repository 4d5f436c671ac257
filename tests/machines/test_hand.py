"""The hand's poses: tips of the fist at the palm, a straight index, and blends that do not jump."""

import numpy as np
import pytest
import statwalk
from statwalk.files.faq.skeleton_text import shipped_skeleton

ROLE = statwalk.load("hand")
HAND = ROLE.character
NAMES = list(HAND.skeleton.names)
TABLE = shipped_skeleton("hand")
FINGERS = ("index", "mid", "ring", "little")
STAND = np.array([[0.0, 1, 0], [1, 0, 0], [0, 0, -1]]) * 0.01
"""from the table's hand in centimetres, along +X, to one that stands, in metres"""
BONES = TABLE.skeleton.names
POSES = ("REST", "FIST", "POINT", "SPREAD")


def ends_of(worlds: np.ndarray) -> dict[str, np.ndarray]:
    """Where the bones end: the table's direction and length in the space of each joint."""
    along = TABLE.attachment() @ STAND.T
    return {
        name: worlds[NAMES.index(name), :3, :3] @ along[row] + worlds[NAMES.index(name), :3, 3]
        for row, name in enumerate(TABLE.skeleton.names)
    }


def posed(clip: str, time: float = 0.0) -> dict[str, np.ndarray]:
    return ends_of(HAND.world(HAND.clips[clip].sample(time)))


def test_its_bones_are_the_faqs():
    expected = TABLE.evaluate()
    rest = HAND.world(HAND.bind_pose)
    for row, name in enumerate(TABLE.skeleton.names):
        np.testing.assert_allclose(rest[NAMES.index(name), :3, 3], STAND @ expected.start[row], atol=1e-6)
        np.testing.assert_allclose(ends_of(rest)[name], STAND @ expected.end[row], atol=1e-6)


def test_the_tips_of_the_fist_lie_at_the_palm():
    ends, wrist, knuckles = posed("fist"), 0.26, 0.35
    for finger in FINGERS:
        x, y, z = ends[f"{finger}end"]
        assert z == pytest.approx(0.02, abs=0.003)  # two centimetres before the bone, on the skin of the palm
        assert wrist < y < knuckles
        assert abs(x) < 0.035


def test_the_thumb_lies_over_the_folded_fingers():
    ends = posed("fist")
    thumb = ends["thumbend"]
    assert thumb[2] > max(ends[f"{finger}end"][2] for finger in FINGERS) + 0.01
    assert ends["littleend"][0] < thumb[0] < ends["thumbbase"][0]


def test_the_index_points_and_the_others_are_folded():
    point, fist = posed("point"), posed("fist")
    way = point["indexend"] - point["palm"]
    assert way[1] / np.linalg.norm(way) > 0.98
    assert np.linalg.norm(way) == pytest.approx(0.093, abs=0.004)
    for finger in FINGERS[1:]:
        np.testing.assert_allclose(point[f"{finger}end"], fist[f"{finger}end"], atol=0.003)


def test_spread_fingers_are_farther_apart_than_at_rest():
    spread, rest = posed("spread"), posed("rest")
    for one, other in zip(("thumb", *FINGERS), FINGERS, strict=False):
        apart = [np.linalg.norm(ends[f"{one}end"] - ends[f"{other}end"]) for ends in (spread, rest)]
        assert apart[0] > apart[1] + 0.004


def test_one_finger_after_the_other():
    ends, clip = (
        [f"{finger}end" for finger in ("little", "ring", "mid", "index", "thumb")],
        HAND.clips["close"],
    )
    first, last = posed("close"), posed("close", clip.duration)
    halfway = []
    for end in ends:
        whole = np.linalg.norm(last[end] - first[end])
        times = np.linspace(0, clip.duration, 60)
        gone = [np.linalg.norm(posed("close", float(time))[end] - first[end]) / whole for time in times]
        halfway.append(times[np.argmax(np.array(gone) > 0.5)])
    assert np.diff(halfway).min() > 0.03


@pytest.mark.parametrize("start", POSES)
@pytest.mark.parametrize("end", POSES)
def test_no_blend_jumps(start, end):
    stage = statwalk.Stage(seed=1)
    actor = stage.add(ROLE)
    stage.send(actor, start)
    stage.step(90)
    stage.send(actor, end)
    tips = []
    for _ in range(75):
        stage.step(1)
        tips.append([ends_of(actor.world)[name] for name in BONES])
    assert actor.state == end
    path = np.array(tips)
    target = posed(end.lower())
    away = [np.linalg.norm(path[-1, row] - target[name]) for row, name in enumerate(BONES)]
    assert max(away) < 0.012  # within what an idle finger moves
    steps = np.linalg.norm(np.diff(path, axis=0), axis=-1)
    way = steps.sum(0) + 0.005  # along the path, and what an idle finger moves
    # the peak of a smooth blend over 0.35 s: 1.9 times its mean speed, 5.8 times its mean change of speed
    assert (steps.max(0) / way).max() < 1.3 * 1.9 / 21
    assert (np.abs(np.diff(steps, axis=0)).max(0) / way).max() < 1.5 * 5.8 / 21**2
