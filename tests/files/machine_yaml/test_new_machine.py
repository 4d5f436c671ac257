"""Machine folders made from models: they load, verify without a finding, and do what their keys say."""

import numpy as np
import pytest
from paths import GLTF, needs_assets
from statwalk.character.role import Role
from statwalk.errors import MachineError
from statwalk.files.character_file import load_character_file
from statwalk.files.machine_yaml.machine_file import load_machine
from statwalk.files.machine_yaml.new_machine import motions_of, write_machine
from statwalk.machine.compile.compile_machine import MotionFacts
from statwalk.machine.verify import verify
from statwalk.stage.stage import Stage

MODELS = ("RobotExpressive", "Quaternius_PlatformerCharacter", "KayKit_Knight", "Khronos_Fox", "CesiumMan")
pytestmark = needs_assets


def made(name, folder, copy=True):
    source = GLTF / f"{name}.glb"
    character = load_character_file(source)
    file = load_machine(write_machine(character, source, folder / name, copy))
    return character, file


@pytest.mark.parametrize("name", MODELS)
def test_nothing_is_to_be_found_in_it(name, tmp_path):
    character, file = made(name, tmp_path)
    motions = {key: MotionFacts(clip.duration, clip.loop) for key, clip in character.clips.items()}
    assert len(file.definition.states) == len(character.clips)
    assert verify(file.definition, motions) == []


@pytest.mark.parametrize("name", ["RobotExpressive", "Khronos_Fox", "CesiumMan"])
def test_its_table_is_complete(name, tmp_path):
    _, file = made(name, tmp_path)
    definition = file.definition
    assert set(definition.cells) == {
        (state, event) for state in definition.states for event in definition.columns
    }


def test_a_jump_of_several_clips_is_the_faqs(tmp_path):
    _, file = made("Quaternius_PlatformerCharacter", tmp_path)
    cells = {
        place: cell.to
        for place, cell in file.definition.cells.items()
        if place[0] in ("JUMP", "FLY") and cell.to
    }
    assert cells == {("JUMP", "END"): "FLY", ("FLY", "END"): "LAND"}


def test_a_robot_that_walks_jumps_and_stops(tmp_path):
    character, file = made("RobotExpressive", tmp_path)
    stage = Stage(seed=1)
    actor = stage.add(Role.build("robot", character, file.definition, file.root_joint))
    keys = file.definition.keys
    stage.hold(actor, keys["ArrowUp"].press)
    stage.step(60)
    assert actor.state == "WALK"
    stage.send(actor, keys["Space"].press)
    stage.step(1)
    assert actor.state == "JUMP"
    stage.step(60)
    assert actor.state == "WALK"  # the key is still down
    stage.release(actor, keys["ArrowUp"].press)
    stage.send(actor, keys["ArrowUp"].release)
    stage.step(1)
    assert actor.state == "STAT"


def test_clips_that_walk_on_the_spot_move_the_actor(tmp_path):
    _, file = made("RobotExpressive", tmp_path)
    walks = {name for name, state in file.definition.states.items() if state.ground_speed == "found"}
    assert walks == {"WALK", "RUN"}


def test_the_model_is_copied_or_named(tmp_path):
    _, copied = made("RobotExpressive", tmp_path)
    assert copied.character_path == tmp_path / "RobotExpressive" / "RobotExpressive.glb"
    assert copied.character_path.read_bytes() == (GLTF / "RobotExpressive.glb").read_bytes()
    _, named = made("RobotExpressive", tmp_path / "other", copy=False)
    assert named.character_path.resolve() == (GLTF / "RobotExpressive.glb").resolve()
    assert not (tmp_path / "other" / "RobotExpressive" / "RobotExpressive.glb").exists()


def test_a_machine_is_never_written_over(tmp_path):
    made("RobotExpressive", tmp_path)
    with pytest.raises(MachineError, match="this folder already holds a machine"):
        made("RobotExpressive", tmp_path)


def test_a_model_without_animations_stands_in_one_state(tmp_path):
    character, file = made("M2M_rig_human", tmp_path)
    stage = Stage(seed=1)
    actor = stage.add(Role.build("rig", character, file.definition, file.root_joint))
    stage.step(30)
    stage.send(actor, "STOP")
    stage.step(30)
    assert (list(file.definition.states), actor.state) == (["STAT"], "STAT")
    np.testing.assert_array_equal(actor.pose.rotation, character.bind_pose.rotation)
    np.testing.assert_array_equal(actor.pose.translation, character.bind_pose.translation)
    assert verify(file.definition, {}) == []


def test_large_tables_are_for_a_spreadsheet(tmp_path):
    made("KayKit_Knight", tmp_path)
    assert (tmp_path / "KayKit_Knight" / "table.csv").read_text().startswith("state,1H_MELEE_ATTACK_CHOP,")


def test_the_idle_motion_comes_first():
    assert motions_of(load_character_file(GLTF / "Khronos_Fox.glb"))[0].clip == "Survey"
