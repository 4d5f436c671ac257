"""FF3 DirectX .x in text form: statwalk reads what assimp reads, and assimp reads what statwalk writes; the
second source's listings; a file, an upload, a conversion and a machine of it.
"""

from pathlib import Path

import assimp
import numpy as np
import pytest
import small_x
import statwalk
from paths import ASSETS, GLTF, GROUND_TRUTH, needs_assets
from scipy.spatial import cKDTree
from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.character_file import load_character_file
from statwalk.files.directx import write_directx
from statwalk.files.machine_yaml.new_machine import write_machine
from statwalk.maths.pose import Pose
from statwalk.services.library.model_store import ModelStore
from uploads import make, opened, put

FOLDER = ASSETS / "x"
WRITTEN = ("RobotExpressive", "CesiumMan", "Khronos_Fox", "RiggedSimple", "BoxAnimated")
MODEL_SIZE = 2e-6
"""largest difference, in parts of the size: assimp writes six digits"""


def vertices(character: Character, pose: Pose) -> np.ndarray:
    return np.concatenate([part.positions for part in character.vertices(pose)])


def apart(mine: np.ndarray, other: np.ndarray) -> float:
    """The largest distance from a vertex of either to the nearest of the other, in parts of the size."""
    ways = cKDTree(mine).query(other)[0].max(), cKDTree(other).query(mine)[0].max()
    return max(ways) / np.ptp(other, 0).max()


def save(folder: Path, text: str | bytes, name: str = "arm.x") -> Path:
    (folder / name).write_bytes(text if isinstance(text, bytes) else text.encode())
    return folder / name


# --- read


@needs_assets
def test_the_cube_is_the_one_of_the_ground_truth() -> None:
    truth = np.load(GROUND_TRUTH / "x" / "test_cube_text.x.gt.npz")["bind_world"]
    cube = load_character_file(FOLDER / "test_cube_text.x")
    assert cube.world(cube.bind_pose)[:, :3] == pytest.approx(truth, abs=1e-6)
    assert cube.skeleton.names == ("Root", "Cube")
    assert len(vertices(cube, cube.bind_pose)) == 24


@needs_assets
@assimp.needs_assimp
@pytest.mark.parametrize("seconds", [0.0, 0.26, 0.7, 1.0])
def test_joints_of_a_skinned_file_move_as_assimp_moves_them(tmp_path: Path, seconds: float) -> None:
    cylinder = load_character_file(FOLDER / "anim_test.x")
    scene = assimp.read(FOLDER / "anim_test.x", tmp_path)
    there = assimp.world(scene, scene.clips[0], seconds)
    here = cylinder.world(cylinder.clips["cylinder_test"].sample(seconds))
    for name, matrix in zip(cylinder.skeleton.names, here, strict=True):
        assert matrix == pytest.approx(there[name], abs=2e-5)


@needs_assets
def test_the_cylinder_rests_where_its_mesh_is() -> None:
    """Its two lower bones are not in the file: what they moved rests or follows the others."""
    cylinder = load_character_file(FOLDER / "anim_test.x")
    at_rest = vertices(cylinder, cylinder.bind_pose)
    assert apart(at_rest, cylinder.parts[0].positions) < 0.02
    assert any("joint3, joint4" in note for note in cylinder.notes)


@needs_assets
def test_a_binary_file_is_refused_with_what_to_do() -> None:
    with pytest.raises(
        ContentError, match=r"test_cube_binary\.x, line 1: this \.x file is binary; .* save it again"
    ):
        statwalk.load(FOLDER / "test_cube_binary.x")


def test_the_listings_of_the_second_source(tmp_path: Path) -> None:
    thing = load_character_file(save(tmp_path, small_x.LISTING_7_AND_8))
    assert thing.skeleton.names == ("Object_Root", "Object_Child")
    assert thing.world(thing.bind_pose)[:, :3, 3].tolist() == [[1, 0, 0], [1, 2, 0]]
    assert [(part.joint, part.positions[:, 2].tolist()) for part in thing.parts] == [
        (0, [0] * 3),
        (1, [-1] * 3),
    ]
    assert thing.chains == {"MyIK": ("Object_Root", "Object_Child")}


def test_a_chain_of_the_file_reaches(tmp_path: Path) -> None:
    arm = load_character_file(save(tmp_path, small_x.ARM))
    answer = arm.solve(arm.bind_pose, "Reach", [0, 1, 2], "ccd")
    assert arm.world(answer.pose)[2, :3, 3] == pytest.approx([0, 1, 2], abs=1e-3)


# --- written


@needs_assets
@assimp.needs_assimp
@pytest.mark.parametrize("name", WRITTEN)
def test_assimp_poses_the_vertices_of_a_written_model_where_they_were(tmp_path: Path, name: str) -> None:
    model = load_character_file(GLTF / f"{name}.glb")
    scene = assimp.read(save(tmp_path, write_directx(model)), tmp_path)
    assert len(scene.clips) == len(model.clips)
    rest = model.bind_pose.weights
    for mine, other in list(zip(model.clips.values(), scene.clips, strict=True))[:4]:
        pose = mine.sample(0.4 * mine.duration)._replace(weights=rest)
        there = assimp.vertices(scene, assimp.world(scene, other, 0.4 * mine.duration))
        assert apart(vertices(model, pose), there) < MODEL_SIZE * 5


@needs_assets
@pytest.mark.parametrize("name", WRITTEN)
def test_a_written_model_reads_back_with_the_same_vertices(tmp_path: Path, name: str) -> None:
    model = load_character_file(GLTF / f"{name}.glb")
    back = load_character_file(save(tmp_path, write_directx(model)))
    assert len(back.skeleton) == len(model.skeleton)
    for mine, other in zip(model.clips.values(), back.clips.values(), strict=True):
        assert other.duration == pytest.approx(mine.duration, abs=1e-5)
        pose = mine.sample(0.3 * mine.duration)._replace(weights=model.bind_pose.weights)
        assert apart(vertices(model, pose), vertices(back, other.sample(0.3 * mine.duration))) < MODEL_SIZE


# --- reached by users


def test_convert_writes_and_reads_it_and_says_what_is_lost(tmp_path: Path) -> None:
    report = statwalk.convert("faq-walker", tmp_path / "walker.x")
    assert "DirectX .x cannot hold" in str(report)
    assert not {loss.part for loss in report.lost} & {"meshes", "skins", "clips", "materials"}
    back = statwalk.convert(tmp_path / "walker.x", tmp_path / "walker.glb")
    assert (back.joints, back.clips) == (report.joints, report.clips)


def test_a_machine_of_it_is_made_and_loaded(tmp_path: Path) -> None:
    arm = save(tmp_path, small_x.ARM)
    folder = write_machine(load_character_file(arm), arm, tmp_path / "machine", copy=False)
    role = statwalk.load(folder)
    assert "arm.x" in (folder / "machine.yaml").read_text()
    assert role.character.skeleton.names == ("Root", "Arm", "Hand")


@pytest.mark.anyio
async def test_an_upload_becomes_a_machine_and_keeps_its_chains(tmp_path: Path) -> None:
    async with opened(tmp_path) as client:
        taken = await put(client, "arm", small_x.ARM.encode())
        assert taken.status_code == 201, taken.text
        facts = taken.json()
        assert (facts["joints"], facts["clips"], facts["skins"], facts["vertices"]) == (3, 2, 1, 4)
        assert any("picture" in note for note in facts["notes"])
        assert (await client.get(facts["model"])).content.startswith(b"glTF")
        made = await make(client, character="arm", mapping={"Bend": "STAT", "Turn": "WALK"})
        assert made.status_code == 201, made.text
    assert ModelStore(tmp_path).character(facts["sha256"]).chains == {"Reach": ("Root", "Hand")}


@pytest.mark.anyio
async def test_a_broken_upload_is_refused_with_the_line(tmp_path: Path) -> None:
    broken = small_x.ARM.replace("1; 4; 3,2,1,0;;", "1; 4; 3,2,1,4;;", 1)
    async with opened(tmp_path) as client:
        answer = await put(client, "arm", broken.encode())
    assert answer.status_code == 422
    assert "line 10: " in answer.text
