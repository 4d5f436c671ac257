"""Which states the clips of real models propose to be, and the machines that are made with these names."""

from pathlib import Path

import pytest
import tiny_model
from paths import GLTF, needs_assets
from statwalk.character.role import Role
from statwalk.errors import UnknownNameError
from statwalk.files.character_file import load_character_file
from statwalk.files.gltf import read_model
from statwalk.files.machine_yaml.machine_file import load_machine, read_machine
from statwalk.files.machine_yaml.new_machine import machine_text, named_motions, write_folder
from statwalk.files.machine_yaml.state_names import proposed
from statwalk.machine.compile.compile_machine import MotionFacts
from statwalk.machine.verify import verify
from statwalk.stage.stage import Stage

EXPECTED = {
    "RobotExpressive": {
        "Idle": "STAT",
        "Walking": "WALK",
        "Running": "RUN",
        "Jump": "JUMP",
        "WalkJump": "WALK_JUMP",
        "ThumbsUp": "THUMBS_UP",
    },
    "Quaternius_PlatformerCharacter": {
        "CharacterArmature|Idle": "STAT",
        "CharacterArmature|Walk": "WALK",
        "CharacterArmature|Run": "RUN",
        "CharacterArmature|Jump": "JUMP",
        "CharacterArmature|Jump_Idle": "FLY",
        "CharacterArmature|Jump_Land": "LAND",
        "CharacterArmature|Duck": "CRCH",
        "CharacterArmature|Idle_Gun": "IDLE_GUN",
    },
    "KayKit_Knight": {
        "Idle": "STAT",
        "Walking_A": "WALK",
        "Walking_Backwards": "WALKING_BACKWARDS",
        "Running_A": "RUN",
        "Jump_Start": "JUMP",
        "Jump_Idle": "FLY",
        "Jump_Land": "LAND",
        "Lie_StandUp": "LIE_STAND_UP",
    },
    "Quaternius_Fox": {
        "AnimalArmature|Idle": "STAT",
        "AnimalArmature|Walk": "WALK",
        "AnimalArmature|Gallop": "RUN",
        "AnimalArmature|Jump_ToIdle": "JUMP",
        "AnimalArmature|Idle_HitReact_Left": "IDLE_HIT_REACT_LEFT",
    },
    "CesiumMan": {"clip 0": "CLIP_0"},
    "Khronos_Fox": {"Survey": "STAT", "Walk": "WALK", "Run": "RUN"},
    "KayKit_Med_MovementBasic": {
        "Rig_Medium|T-Pose": "STAT",
        "Rig_Medium|Walking_A": "WALK",
        "Rig_Medium|Jump_Start": "JUMP",
    },
}


def character(name):
    return load_character_file(GLTF / f"{name}.glb")


@needs_assets
@pytest.mark.parametrize("name", EXPECTED)
def test_real_clips(name):
    found = proposed(character(name).clips)
    assert {clip: found[clip] for clip in EXPECTED[name]} == EXPECTED[name]
    assert len(set(found.values())) == len(found)


@needs_assets
@pytest.mark.parametrize("name", EXPECTED)
def test_nothing_is_to_be_found_in_a_machine_of_them(name, tmp_path):
    model = character(name)
    write_folder(name, named_motions(model, proposed(model.clips)), GLTF / f"{name}.glb", tmp_path)
    motions = {key: MotionFacts(clip.duration, clip.loop) for key, clip in model.clips.items()}
    assert verify(load_machine(tmp_path).definition, motions) == []


def test_the_faqs_own_motions():
    clips = [
        "Idle",
        "Walk_Start",
        "Walk",
        "Walk_End",
        "Turn_Left",
        "Turn_Right",
        "Jump",
        "Fall",
        "Land",
        "Crouch",
        "Crouch_Up",
    ]
    expected = ["STAT", "STWK", "WALK", "CSTP", "TLFT", "TRGT", "JUMP", "FLY", "LAND", "CRCH", "STUP"]
    assert list(proposed(clips).values()) == expected


def test_every_state_is_there_once():
    assert proposed(["Armature|FLY", "Flying"]) == {"Armature|FLY": "FLY", "Flying": "FLYING"}


def test_a_clip_called_as_a_state_is_that_state():
    assert proposed(["Jump", "Rig|CSTP", "Jump_Start", "LAND"]) == {
        "Jump": "JUMP_2",
        "Rig|CSTP": "CSTP",
        "Jump_Start": "JUMP",
        "LAND": "LAND",
    }


def test_odd_and_repeated_names_become_valid_states():
    assert list(proposed(["|", "", "a b", "a_b", "x" * 300]).values()) == [
        "MOTION",
        "MOTION_2",
        "A_B",
        "A_B_2",
        "X" * 80,
    ]


FAQ = {
    "Idle": "STAT",
    "Dance": "STWK",
    "Walking": "WALK",
    "No": "CSTP",
    "Jump": "JUMP",
    "Punch": "FLY",
    "Wave": "LAND",
    "Death": "CRCH",
}


def actor_of(states):
    model = character("RobotExpressive")
    definition = read_machine(
        machine_text("robot", named_motions(model, states), GLTF / "RobotExpressive.glb", inline=True)
    )
    stage = Stage(seed=1)
    return stage, stage.add(Role.build("robot", model, definition, None))


def shown(stage, actor, ticks=600):
    """The states that an actor goes through."""
    found = [actor.state]
    for _ in range(ticks):
        stage.step(1)
        if actor.state != found[-1]:
            found.append(actor.state)
    return found


@needs_assets
def test_a_jump_flies_and_lands():
    stage, actor = actor_of(FAQ)
    stage.send(actor, "JUMP")
    assert shown(stage, actor) == ["STAT", "JUMP", "FLY", "LAND", "STAT"]


@needs_assets
def test_a_walk_begins_and_comes_to_a_stop():
    stage, actor = actor_of(FAQ)
    stage.send(actor, "FORWARD")
    assert shown(stage, actor) == ["STAT", "STWK", "WALK"]
    stage.send(actor, "STOP")
    assert shown(stage, actor) == ["WALK", "CSTP", "STAT"]


@needs_assets
def test_without_a_landing_a_flight_is_asked_for():
    stage, actor = actor_of({"Idle": "STAT", "Jump": "JUMP", "Dance": "FLY"})
    stage.send(actor, "JUMP")
    assert shown(stage, actor) == ["STAT", "JUMP", "STAT"]
    stage.send(actor, "FLY")
    assert shown(stage, actor)[:2] == ["STAT", "FLY"]


@needs_assets
def test_a_walk_goes_on_whatever_its_clip_is_called():
    stage, actor = actor_of({"Idle": "STAT", "Punch": "WALK"})
    stage.send(actor, "FORWARD")
    assert shown(stage, actor) == ["STAT", "WALK"]


ODD = [
    "\0",
    "a\nb",
    "\x7f",
    "\x85",
    "\u2028",
    "\ufffe",
    "\U0001ffff",
    "🦊 run",
    "'\"\\",
    "# x",
    "- a",
    "{a: b}",
    "&x *y !z",
    "null",
    "1e3",
    "~",
    " ",
    "İ",
    "*",
]


@pytest.mark.parametrize("clip", ODD, ids=ascii)
def test_odd_clips_come_back_from_the_machine_file(clip):
    model = read_model(tiny_model.changed("/animations/0/name", clip), "tiny")
    text = machine_text("tiny", named_motions(model, proposed(model.clips)), Path("tiny.glb"), inline=True)
    assert [state.motion for state in read_machine(text).states.values()] == list(model.clips)


@needs_assets
def test_only_clips_of_the_model_are_named():
    with pytest.raises(UnknownNameError, match="Walkign"):
        named_motions(character("RobotExpressive"), {"Walkign": "WALK"})


@needs_assets
def test_a_model_without_animations_has_its_pose_at_rest():
    (motion,) = named_motions(load_character_file(GLTF / "M2M_rig_human.glb"), {})
    assert (motion.clip, motion.state, motion.event) == ("", "STAT", "")
