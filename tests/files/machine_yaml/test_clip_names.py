"""What the names of real clips say: RobotExpressive's, Quaternius's, KayKit's and the Khronos fox's."""

import pytest
from statwalk.files.machine_yaml.clip_names import idle_rank, kind, state_name, words

LOOPS = [
    "Idle",
    "Walking",
    "Running",
    "Dance",
    "CharacterArmature|Run_Shoot",
    "Walking_Backwards",
    "Sit_Chair_Idle",
    "Jump_Idle",
    "Survey",
    "Blocking",
]
ONCE = [
    "Jump",
    "WalkJump",
    "Punch",
    "No",
    "Yes",
    "ThumbsUp",
    "Wave",
    "AnimalArmature|Idle_HitReact_Left",
    "1H_Melee_Attack_Chop",
    "Lie_StandUp",
]
REST = ["Death", "Death_A", "Sitting", "Lie_Down", "T-Pose", "CharacterArmature|Duck"]


@pytest.mark.parametrize(
    ("clip", "expected"),
    [
        *((clip, "loop") for clip in LOOPS),
        *((clip, "once") for clip in ONCE),
        *((clip, "rest") for clip in REST),
    ],
)
def test_kinds(clip, expected):
    assert kind(clip, 1.0, comes_round=expected != "loop") == expected


def test_a_name_that_says_nothing_leaves_it_to_the_poses():
    assert (kind("Take 001", 1.0, comes_round=True), kind("Take 001", 1.0, comes_round=False)) == (
        "loop",
        "once",
    )


def test_a_single_pose_stays():
    assert kind("Walking", 0.0, comes_round=True) == "rest"


def test_words():
    assert words("CharacterArmature|Run_Gun") == ["run", "gun"]
    assert words("WalkJump2") == ["walk", "jump", "2"]


def test_states_and_events_have_valid_names_of_their_own():
    assert state_name("Armature|Run fast!", ()) == "Run_fast"
    assert state_name("clip 0", ["clip_0", "clip_0_2"]) == "clip_0_3"
    assert state_name("|", ()) == "Motion"


def test_the_plainest_idle_comes_first():
    assert min(["Walk", "Idle_Gun", "Idle", "Standing"], key=idle_rank) == "Idle"
    assert min(["Walk", "Survey", "Run"], key=idle_rank) == "Survey"
