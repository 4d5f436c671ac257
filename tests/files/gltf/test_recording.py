import json
from dataclasses import replace

import khronos
import numpy as np
import pytest
from paths import ASSETS
from reference_poses import MODELS, character
from scipy.spatial.transform import Rotation
from statwalk.files.gltf import read_model
from statwalk.files.gltf.recording import recording_glb
from statwalk.files.gltf.recording_draft import Recorded
from statwalk.files.gltf.template import PosedCast, stage_worlds
from statwalk.files.gltf.world_keys import METRES
from statwalk.files.gltf.write import model_glb
from statwalk.maths.pose import Pose
from statwalk.rig.skeleton import Skeleton
from tiny_model import changed, model

RATE = 60
SHARED = [
    "RobotExpressive.glb",
    "Quaternius_Fox.glb",
    "KayKit_Knight.glb",
    "CesiumMan.glb",
    "synthetic/morph_and_skin.glb",
]
SKINNED = (
    SHARED if ASSETS.is_dir() else ["faq-walker/walker.glb", "geese/goose/goose.glb", "swarm/bee/bee.glb"]
)


def walking(source, ticks=40, name="one", aside=0.0):
    """The first clip of a character, or its rest, while it goes round a corner."""
    clip = next(iter(source.clips.values()), None)
    time = np.arange(ticks) / RATE
    poses = (
        clip.sample(time, loop=True)
        if clip
        else Pose(*(np.stack([array] * ticks) for array in source.bind_pose))
    )
    places = np.stack([aside + time, 0 * time, np.maximum(time - 0.3, 0)], -1)
    return Recorded(name, source, poses, places, np.where(time < 0.3, 0, time - 0.3))


def in_stage(actor, tick):
    """Positions of an actor's parts in the stage at a tick, from the poses it was recorded with."""
    row = slice(tick, tick + 1)
    world = stage_worlds(
        actor.character, PosedCast(actor.poses.take(row), actor.root_position[row], actor.heading[row])
    )[0]
    return np.concatenate(
        [part.positions for part in actor.character.surface.posed_parts(world, actor.poses.weights[tick])]
    )


def shown(data, tick):
    """The same in the recording, read again."""
    again = read_model(data, "again")
    return np.concatenate(
        [part.positions for part in again.vertices(again.clips["recording"].sample(tick / RATE))]
    )


def joints_in_stage(actor):
    """(T,J,3) where an actor's joints were, from the poses it was recorded with."""
    return stage_worlds(actor.character, PosedCast(actor.poses, actor.root_position, actor.heading))[..., 3]


def joints_shown(data, actor):
    """The same in the recording, read again: node 0 goes the way, the joints follow in their order.

    Ticks as 32-bit floats, like keys.
    """
    again = read_model(data, "again")
    ticks = (np.arange(len(actor.heading)) / RATE).astype(np.float32)
    rows = np.argsort(again.node_index)[1 : len(actor.character.skeleton) + 1]
    return again.world(again.clips["recording"].sample(ticks))[..., :3, 3][:, rows]


def farthest(actor):
    """Metres between a joint's place in the recording and in the stage, the largest of all ticks."""
    return np.linalg.norm(
        joints_shown(recording_glb([actor], RATE), actor) - joints_in_stage(actor), axis=-1
    ).max()


def json_of(data):
    return json.loads(data[20 : 20 + int.from_bytes(data[12:16], "little")])


def size_of(points):
    return float(np.ptp(points, axis=0).max())


@pytest.fixture(scope="module")
def tiny():
    return read_model(model(), "tiny")


@pytest.mark.parametrize("tick", [0, 7, 18, 39])
def test_it_shows_what_was_recorded(tiny, tick):
    actor = walking(tiny)
    assert shown(recording_glb([actor], RATE), tick) == pytest.approx(in_stage(actor, tick), abs=1e-3)


@pytest.mark.parametrize("tick", [0, 11, 39])
@pytest.mark.parametrize("name", SKINNED)
def test_real_characters_come_back(name, tick):
    actor = walking(character(name))
    expected = in_stage(actor, tick)
    assert np.abs(shown(recording_glb([actor], RATE), tick) - expected).max() <= 1e-3 * max(
        size_of(expected), 1
    )


@pytest.mark.parametrize("name", MODELS)
def test_no_joint_strays_from_its_place_in_the_stage(name):
    assert farthest(walking(character(name), ticks=90)) <= METRES + 1e-5


def test_errors_do_not_add_up_along_a_chain(tiny):
    joints, ticks = 40, 120
    turns = Rotation.from_rotvec(
        np.sin(np.arange(ticks)[:, None] / 9 + np.arange(joints))[..., None].reshape(-1, 1) * [[0, 0, 0.2]]
    )
    poses = Pose(
        np.tile(np.float32([0, 0.1, 0]), (ticks, joints, 1)),
        turns.as_quat().reshape(ticks, joints, 4).astype(np.float32),
        np.ones((ticks, joints, 3), np.float32),
        np.zeros((ticks, 0), np.float32),
    )
    skeleton = Skeleton(
        tuple(f"joint {row}" for row in range(joints)), np.arange(-1, joints - 1, dtype=np.int32)
    )
    chain = replace(
        tiny, skeleton=skeleton, node_index=np.arange(joints), bind_pose=poses.take(0), skins=(), parts=()
    )
    assert farthest(Recorded("chain", chain, poses, np.zeros((ticks, 3)), np.zeros(ticks))) <= METRES + 1e-5


def test_two_actors_share_their_mesh(tiny):
    found = json_of(recording_glb([walking(tiny), walking(tiny, name="two", aside=3)], RATE))
    assert (
        len(found["meshes"]),
        len(found["skins"]),
        [node["mesh"] for node in found["nodes"] if "mesh" in node],
    ) == (1, 2, [0, 0])


def test_two_actors_are_each_in_their_place(tiny):
    actors = [walking(tiny), walking(tiny, name="two", aside=3)]
    expected = np.concatenate([in_stage(actor, 20) for actor in actors])
    assert shown(recording_glb(actors, RATE), 20) == pytest.approx(expected, abs=1e-3)


def test_it_lasts_as_long_as_the_ticks(tiny):
    still = walking(tiny)._replace(root_position=np.zeros((40, 3)))
    assert read_model(recording_glb([still], RATE), "again").clips["recording"].duration == pytest.approx(
        39 / RATE
    )


def test_the_keys_are_ticks_of_the_stage(tiny):
    clip = read_model(recording_glb([walking(tiny)], RATE), "again").clips["recording"]
    ticks = np.concatenate([channel.times for channel in clip.channels]) * RATE
    assert ticks == pytest.approx(np.rint(ticks), abs=1e-4)


def test_an_actor_that_came_later_starts_later(tiny):
    late = walking(tiny, ticks=10)._replace(first=30)
    assert read_model(recording_glb([late], RATE), "again").clips["recording"].duration == pytest.approx(
        39 / RATE
    )


def test_keys_that_do_not_matter_are_dropped(tiny):
    clip = read_model(recording_glb([walking(tiny, ticks=600)], RATE), "again").clips["recording"]
    assert all(len(channel.times) < 300 for channel in clip.channels)


def test_what_never_moves_has_no_channel(tiny):
    found = json_of(recording_glb([walking(tiny)], RATE))
    moved = {
        (found["nodes"][c["target"]["node"]]["name"], c["target"]["path"])
        for c in found["animations"][0]["channels"]
    }
    assert moved == {("one", "translation"), ("one", "rotation"), ("knee", "rotation")}


def test_meshes_that_share_a_joint_keep_a_node_each():
    rigid = read_model(changed("/nodes/2", {"mesh": 0}), "rigid")
    second = replace(rigid.parts[0], node=9, mesh=1, positions=rigid.parts[0].positions + 5)
    actor = walking(replace(rigid, parts=(*rigid.parts, second)))
    assert shown(recording_glb([actor], RATE), 30) == pytest.approx(in_stage(actor, 30), abs=1e-3)


@pytest.mark.parametrize("ticks", [1, 2])
def test_the_shortest_recordings_are_valid(tiny, ticks):
    assert clean(khronos.issues(recording_glb([walking(tiny, ticks)], RATE))[0]) == []


def test_an_empty_stage_is_a_valid_file():
    assert khronos.errors(recording_glb([], RATE)) == []


def clean(report):
    return [message["code"] for message in report["messages"] if message["severity"] == 0]


@pytest.fixture(scope="module")
def reports():
    """For each model what the validator says of the source and of a recording of it."""
    sources = [character(name) for name in MODELS]
    before = khronos.issues(*(source.model_glb or model_glb(source) for source in sources))
    after = khronos.issues(
        *(recording_glb([walking(source), walking(source, name="two")], RATE) for source in sources)
    )
    return dict(zip(MODELS, zip(before, after, strict=True), strict=True))


@pytest.mark.parametrize("name", MODELS)
def test_the_validator_finds_no_error_and_no_new_kind_of_warning(reports, name):
    source, recording = reports[name]
    assert clean(recording) == []
    warned = [{m["code"] for m in report["messages"] if m["severity"] == 1} for report in (source, recording)]
    assert warned[1] <= warned[0]
