"""The walker's clips by number: feet that stay, soles over the ground, joints within limits, motions that
meet (guide to motion).
"""

import subprocess
import sys
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from paths import MACHINES
from sole_points import RATE, slides, soles_of, times_of
from statwalk.files.gltf import read_model

WALKER = read_model((MACHINES / "faq-walker" / "walker.glb").read_bytes(), "walker", None)
JOINT = {name: index for index, name in enumerate(WALKER.skeleton.names)}
SIDES = ("Left", "Right")
LIMBS = ("shoulder", "upperarm", "lowerarm", "hand", "butt", "upperleg", "lowerleg", "foot")
BONES = [JOINT[name] for name in ("Root", "Lowerback", "Upperback", "Head")]
BONES += [JOINT[f"{side}.{bone}"] for side in SIDES for bone in LIMBS]  # the FAQ's: what motions move
STOPS = tuple(f"come-to-stop-{side}-{number}" for side in ("left", "right") for number in range(1, 7))
SHORT_STOPS = ("come-to-stop-short-1", "come-to-stop-short-2")
JUMPS = tuple(f"jump-{side}-{number}" for side in ("left", "right") for number in range(1, 5))
MEETINGS = [
    *(("start-walk", "walk"), ("walk", "walk"), ("stand", "stand"), ("stand-up", "stand"), ("rise", "stand")),
    *((name, "stand") for name in (*STOPS, *SHORT_STOPS, "come-to-rest", "turn-left", "turn-right")),
    *(("stand", "start-walk"), ("stand", "turn-left"), ("stand", "turn-right"), ("stand", "crouch")),
    *((name, "fly") for name in JUMPS),
    *(("fly", "land"), ("land", "absorb"), ("absorb", "rise"), ("crouch", "stand-up")),
]
# guide to motion: degrees at the eight keys, from this leg's heel strike
HIP = (30, 25, 11, -3, -10, 0, 23, 32)
KNEE = (5, 18, 12, 6, 10, 38, 60, 28)
SHOULDER = (-22, -18, -6, 6, 12, 10, 0, -14)
ELBOW = (12, 14, 20, 28, 32, 28, 20, 14)
ANKLE = (0, -5, 3, 8, 8, -17, -3, 1)


@cache
def joints(name: str) -> np.ndarray:
    """World positions (F, J, 3) of the joints through a clip."""
    clip = WALKER.clips[name]
    return np.array([WALKER.world(clip.sample(float(t)))[:, :3, 3] for t in times_of(clip)], float)


@cache
def soles(name: str) -> dict[str, np.ndarray]:
    return soles_of(WALKER, WALKER.clips[name])


def hinge_deg(name: str, joint: str) -> np.ndarray:
    """Turn about the joint's own X through a clip, degrees."""
    clip = WALKER.clips[name]
    q = np.array([clip.sample(float(t)).rotation[JOINT[joint]] for t in times_of(clip)], float)
    return np.degrees(2 * np.arctan2(q[:, 0] * np.sign(q[:, 3]), np.abs(q[:, 3])))


def state_at(name: str, end: bool) -> tuple[np.ndarray, np.ndarray]:
    """Places and speeds of the joints at a clip's first or last moment, seen from the root on the ground."""
    path, step = joints(name)[::2], 2.0 / RATE  # as far apart as the keys
    ahead = WALKER.world(WALKER.clips[name].sample(WALKER.clips[name].duration if end else 0.0))[
        JOINT["Root"], :3, 2
    ]
    c, s = np.array([ahead[2], ahead[0]]) / np.hypot(ahead[0], ahead[2])
    turn = np.array([[c, 0, -s], [0, 1, 0], [s, 0, c]])
    a, b, d = (path[-1], path[-2], path[-3]) if end else (path[0], path[1], path[2])
    speed = (3 * a - 4 * b + d) / (2 * step) * (1 if end else -1)
    return ((a - a[JOINT["Root"]] * (1, 0, 1)) @ turn.T)[BONES], (speed @ turn.T)[BONES]


def hardest(name: str) -> float:
    """The largest acceleration of any joint in a clip, metres a second squared."""
    return (
        float(np.linalg.norm(np.diff(joints(name)[::2, BONES], 2, axis=0), axis=-1).max()) * (RATE / 2) ** 2
    )


def test_the_motions_of_eleven_states() -> None:
    others = "stand start-walk walk come-to-rest turn-left turn-right walk-turn-left walk-turn-right fly land"
    expected = {*STOPS, *SHORT_STOPS, *JUMPS, *others.split(), "absorb", "rise", "crouch", "stand-up"}
    assert set(WALKER.clips) == expected


def test_the_bones_of_the_faq() -> None:
    parent = {
        name: WALKER.skeleton.names[p] if p >= 0 else ""
        for name, p in zip(WALKER.skeleton.names, WALKER.skeleton.parent, strict=True)
    }
    for side in SIDES:
        chain = ["shoulder", "upperarm", "lowerarm", "hand"], ["butt", "upperleg", "lowerleg", "foot"]
        for bones, top in zip(chain, ("Upperback", "Root"), strict=True):
            path = [top, *(f"{side}.{bone}" for bone in bones)]
            assert [parent[name] for name in path[1:]] == path[:-1]
    assert [parent[name] for name in ("Lowerback", "Upperback", "Head")] == ["Root", "Lowerback", "Upperback"]


@pytest.mark.parametrize("name", [name for name in WALKER.clips if name != "fly"])
def test_planted_feet_do_not_slide(name: str) -> None:
    dragged = [slide for side in SIDES for slide in slides(soles(name)[side])]
    assert dragged, "no foot ever touches the ground"
    assert max(dragged) < 0.014  # in the two ticks in which it comes down or leaves


@pytest.mark.parametrize("name", WALKER.clips)
def test_soles_stay_over_the_ground(name: str) -> None:
    assert min(points[..., 1].min() for points in soles(name).values()) > -0.005


@pytest.mark.parametrize("name", WALKER.clips)
def test_knees_and_elbows_bend_their_way_and_never_lock(name: str) -> None:
    for side in SIDES:
        knee, elbow = hinge_deg(name, f"{side}.lowerleg"), -hinge_deg(name, f"{side}.lowerarm")
        assert 5 < knee.min() < knee.max() < 120
        assert 5 < elbow.min() < elbow.max() < 120


@pytest.mark.parametrize("name", WALKER.clips)
def test_no_joint_jerks(name: str) -> None:
    assert hardest(name) < (250 if name in (*JUMPS, "fly", "land") else 125)


@pytest.mark.parametrize(("first", "second"), MEETINGS)
def test_motions_meet_in_place_and_speed(first: str, second: str) -> None:
    (place, speed), (next_place, next_speed) = state_at(first, end=True), state_at(second, end=False)
    assert np.abs(place - next_place).max() < 0.002
    assert np.abs(speed - next_speed).max() < 0.02 + 0.5 * max(hardest(first), hardest(second)) * 2 / RATE


def test_flight_is_ballistic() -> None:
    height = joints("fly")[::4, JOINT["Root"], 1]
    assert np.diff(height, 2) * (RATE / 4) ** 2 == pytest.approx(-9.81, abs=0.6)


def test_walk_has_the_speed_and_the_rise_of_a_grown_up() -> None:
    root = joints("walk")[:, JOINT["Root"]]
    assert 1.3 <= root[-1, 2] <= 1.4
    assert 1.0 <= WALKER.clips["walk"].duration <= 1.1
    assert 0.030 <= np.ptp(root[:, 1]) <= 0.050
    assert 0.03 <= np.ptp(root[:, 0]) <= 0.05


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize(
    ("bone", "sign", "keys", "within"),
    [
        ("upperleg", -1, HIP, 10),
        ("lowerleg", 1, KNEE, 11),
        ("upperarm", -1, SHOULDER, 9),
        ("lowerarm", -1, ELBOW, 5),
    ],
)
def test_walk_keeps_to_clinical_averages(
    side: str, bone: str, sign: int, keys: tuple[int, ...], within: float
) -> None:
    assert sign * pitches(side, bone) == pytest.approx(np.array(keys), abs=within)


@pytest.mark.parametrize("side", SIDES)
def test_ankles_keep_to_clinical_averages(side: str) -> None:
    """From the foot at rest, toes up."""
    at_rest = WALKER.bind_pose.rotation[JOINT[f"{side}.foot"]].astype(float)
    level = np.degrees(2 * np.arctan2(at_rest[0], at_rest[3]))
    assert level - pitches(side, "foot") == pytest.approx(np.array(ANKLE), abs=9)


def pitches(side: str, bone: str) -> np.ndarray:
    """Degrees about X of a bone at eight phases of the walk, from the contact of its side on."""
    phase = np.arange(8) / 8 + (0.0 if side == "Left" else 0.5)
    clip, joint = WALKER.clips["walk"], JOINT[f"{side}.{bone}"]
    q = np.array([clip.sample(float(p % 1.0) * clip.duration).rotation[joint] for p in phase], float)
    angles: np.ndarray = np.degrees(2 * np.arctan2(q[:, 0], q[:, 3]))
    return angles


@pytest.mark.parametrize(
    ("name", "angle"),
    [
        *(("turn-left", 60.0), ("turn-right", -60.0), ("walk-turn-left", 60.0), ("walk-turn-right", -60.0)),
        *(("walk", 0.0), ("come-to-stop-left-1", 0.0)),
    ],
)
def test_turns_go_the_way_they_say(name: str, angle: float) -> None:
    ahead = [
        WALKER.world(WALKER.clips[name].sample(t))[JOINT["Root"], :3, 2]
        for t in (0.0, WALKER.clips[name].duration)
    ]
    start, end = (np.degrees(np.arctan2(way[0], way[2])) for way in ahead)
    assert end - start == pytest.approx(angle, abs=0.1)


@pytest.mark.parametrize("name", WALKER.clips)
def test_no_hand_is_faster_than_60_metres_a_second_squared(name: str) -> None:
    hands = joints(name)[::2, [JOINT["Left.hand"], JOINT["Right.hand"]]]
    assert np.linalg.norm(np.diff(hands, 2, axis=0), axis=-1).max() * (RATE / 2) ** 2 < 60


def test_arms_swing_back_as_far_as_forward() -> None:
    """Hands against their shoulders, along the path."""
    for side in SIDES:
        reach = joints("walk")[:, JOINT[f"{side}.hand"], 2] - joints("walk")[:, JOINT[f"{side}.upperarm"], 2]
        assert reach.max() == pytest.approx(-reach.min(), abs=0.06)


def test_crouching_hands_rest_on_the_thighs_and_are_not_mirrored() -> None:
    pose = joints("crouch")[-1]
    along = []
    for side in SIDES:
        hip, knee, wrist = (pose[JOINT[f"{side}.{bone}"]] for bone in ("upperleg", "lowerleg", "hand"))
        thigh = knee - hip
        along.append((wrist - hip) @ thigh / (thigh @ thigh))
        assert np.linalg.norm(wrist - hip - along[-1] * thigh) < 0.13  # a thigh is 7 cm thick
    assert 0.02 < along[0] - along[1] < 0.2


@pytest.mark.parametrize("number", range(1, 7))
def test_a_stop_has_its_mirror_image(number: int) -> None:
    """The feet, seen from where they come to rest; the pelvis then leans on the left foot in both."""
    left, right = (joints(f"come-to-stop-{side}-{number}") for side in ("left", "right"))
    ways = []
    for path, (last, other) in ((left, ("Left", "Right")), (right, ("Right", "Left"))):
        ways.append(
            [path[-1, JOINT[f"{side}.foot"], 2] - path[0, JOINT[f"{side}.foot"], 2] for side in (last, other)]
        )
    assert ways[0] == pytest.approx(ways[1], abs=0.06)


def test_standing_breathes_and_shifts_its_weight() -> None:
    path = joints("stand")
    assert 0.02 < np.ptp(path[:, JOINT["Root"], 0]) < 0.04
    assert np.ptp(path[:, JOINT["Left.hand"]], axis=0).max() > 0.01


def test_the_kept_script_makes_the_shipped_file(tmp_path: Path) -> None:
    target = tmp_path / "walker.glb"
    subprocess.run(
        [sys.executable, MACHINES / "faq-walker" / "make", target], check=True, capture_output=True
    )
    made = read_model(target.read_bytes(), "walker", None)
    for name, clip in made.clips.items():
        for time in np.linspace(0.0, clip.duration, 5):
            assert made.world(clip.sample(float(time))) == pytest.approx(
                WALKER.world(WALKER.clips[name].sample(float(time))), abs=1e-4
            )
