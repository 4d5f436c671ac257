"""The staging camera: what is in its picture by a projection with SciPy, its way by SciPy's linear filter."""

import json

import numpy as np
import pytest
import statwalk
from builders import character
from paths import MACHINES
from scipy.signal import lfilter
from scipy.spatial.transform import Rotation
from shots import FILE, shots
from statwalk.character.staging import FRAMINGS, framed
from statwalk.errors import ContentError, UnknownNameError

WALKER = statwalk.load(MACHINES / "faq-walker" / "walker.glb")
STANDING = WALKER.clip("stand").sample(0.0)
SKIN = np.concatenate([part.positions for part in WALKER.vertices(STANDING)]).astype(np.float64)
LOW, HIGH = np.array([-0.5, 0, -0.3]), np.array([0.5, 2, 0.3])


def in_picture(camera, points, aspect=16 / 9, tick=0):
    """Where points are in the picture, (…, 2): its edges are at -1 and 1."""
    seen = Rotation.from_quat(camera.rotation).inv().apply(points - camera.position[tick])
    assert (-seen[:, 2] > camera.near).all()
    assert (-seen[:, 2] < camera.far).all()
    return seen[:, :2] / -seen[:, 2:] / np.tan(camera.field / 2) / [aspect, 1]


@pytest.mark.parametrize("aspect", [16 / 9, 0.5])
def test_the_whole_character_is_in_the_picture(aspect):
    places = in_picture(statwalk.staging(WALKER, STANDING, aspect=aspect), SKIN, aspect)
    assert 0.4 < np.abs(places).max() <= 1


def test_the_face_leaves_the_feet_out():
    places = in_picture(statwalk.staging(WALKER, STANDING, framing="face"), SKIN)
    top, sole = SKIN[:, 1].argmax(), SKIN[:, 1].argmin()
    assert np.abs(places[top]).max() < 1
    assert places[sole, 1] < -2


@pytest.mark.parametrize(
    ("framing", "low", "high"),
    [
        ("whole", LOW, HIGH),
        ("upper body", [-0.5, 1, -0.5], [0.5, 2, 0.5]),
        ("face", [-0.24, 1.6, -0.24], [0.24, 2, 0.24]),
        ("wide", [-1.25, -1.5, -0.75], [1.25, 3.5, 0.75]),
    ],
)
def test_what_a_framing_shows(framing, low, high):
    np.testing.assert_allclose(framed(LOW, HIGH, framing), [low, high])


def test_it_follows_as_a_filter_of_first_order_does():
    path = np.zeros((120, 3))
    path[:, 2] = 1.4 * np.arange(120) / 60
    camera = statwalk.staging(WALKER, STANDING, path)
    share = 1 - np.exp(-1 / (60 * 0.18))
    np.testing.assert_allclose(
        (camera.position - camera.position[0])[:, 2], lfilter([share], [1, share - 1], path[:, 2]), atol=1e-9
    )


def test_a_jump_of_the_root_is_a_cut():
    path = np.array([[0, 0, 0], [0, 0, 0.02], [30, 0, 0]])
    camera = statwalk.staging(WALKER, STANDING, path)
    np.testing.assert_allclose(camera.position[2] - camera.position[0], path[2], atol=1e-12)


def test_it_looks_from_the_front_from_the_side_and_from_above():
    (away,) = statwalk.staging(WALKER, STANDING).position - SKIN.mean(0)
    assert away[2] > away[0] > away[1] - 0.3 > 0


def test_it_looks_at_the_middle_of_a_character_that_has_turned():
    bare = character()  # its arm points along +X: after a quarter turn along -Z
    middle = in_picture(
        statwalk.staging(bare, bare.bind_pose, heading=np.pi / 2), np.array([[0, 1.25, -0.15]])
    )
    np.testing.assert_allclose(middle, 0, atol=1e-6)


def test_a_character_without_skin_is_framed_by_its_joints():
    bare = character()
    joints = bare.world(bare.bind_pose)[:, :3, 3].astype(np.float64)
    assert 0.4 < np.abs(in_picture(statwalk.staging(bare, bare.bind_pose), joints)).max() <= 1


def test_an_unknown_framing_is_refused():
    with pytest.raises(UnknownNameError, match=f"There are: {', '.join(FRAMINGS)}"):
        statwalk.staging(WALKER, STANDING, framing="feet")


@pytest.mark.parametrize(
    "wish", [{"path": []}, {"path": [1, 2, 3]}, {"path": [[np.nan, 0, 0]]}, {"rate": 0}, {"aspect": 0}]
)
def test_a_camera_that_cannot_be_is_refused(wish):
    with pytest.raises(ContentError):
        statwalk.staging(WALKER, STANDING, **wish)


def test_the_shots_that_the_page_is_held_against_are_these():
    """The page's own test compares its camera with the file: `python tests/support/shots.py` writes it."""
    kept, now = json.loads(FILE.read_text()), shots()
    assert json.dumps(_rounded(kept)) == json.dumps(_rounded(now))


def _rounded(value):
    if isinstance(value, dict):
        return {key: _rounded(part) for key, part in value.items()}
    if isinstance(value, list):
        return [_rounded(part) for part in value]
    return round(value, 6) + 0.0 if isinstance(value, float) else value
