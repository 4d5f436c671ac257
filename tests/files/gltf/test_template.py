import json
from concurrent.futures import ThreadPoolExecutor

import khronos
import numpy as np
import pytest
from paths import needs_assets
from reference_poses import MODELS, character
from statwalk.files.gltf import read_model
from statwalk.files.gltf.template import FrameTemplate, PosedCast
from statwalk.maths.pose import Pose
from statwalk.rig.evaluate import world_from_local
from tiny_model import changed, model

PLACES = np.array([[1.0, 0, 2], [3, 0, 4]])
HEADINGS = np.array([0.3, np.pi / 2])


def cast(source, places=PLACES, headings=HEADINGS):
    """Two actors of a character, at different moments of its first clip."""
    clip = next(iter(source.clips.values()), None)
    if clip is None:
        return PosedCast(
            Pose(*(np.stack([array] * len(places)) for array in source.bind_pose)), places, headings
        )
    return PosedCast(clip.sample(np.linspace(0.1, 0.4, len(places))), places, headings)


def frame(source, tick=5, images=False):
    return FrameTemplate([(source, 2)], images=images).frame(tick, "00ff", [cast(source)])


def json_of(data):
    return data[20 : 20 + int.from_bytes(data[12:16], "little")]


@pytest.fixture(scope="module")
def tiny():
    return read_model(model(), "tiny")


def test_vertices_are_where_the_character_puts_them(tiny):
    shown = read_model(frame(tiny), "frame")
    pose = cast(tiny).pose.take(1)
    x, y, z = tiny.vertices(pose)[0].positions.T
    expected = np.stack([z + 3, y, -x + 4], axis=1)  # a quarter turn to the left, then to its place
    assert shown.vertices(shown.bind_pose)[1].positions == pytest.approx(expected, abs=1e-5)


def matrices_of(data, actor):
    """The matrices (1+J,4,4) that `extras.joints` of an actor's node names: the root's, then the joints'."""
    document, text = json.loads(json_of(data)), json_of(data)
    actors = [node for node in document["nodes"] if "extras" in node]
    accessor = document["accessors"][actors[actor]["extras"]["joints"]]
    start = 28 + len(text) + document["bufferViews"][accessor["bufferView"]]["byteOffset"]
    flat = np.frombuffer(data, "<f4", 16 * accessor["count"], start + accessor["byteOffset"])
    return flat.reshape(-1, 4, 4).swapaxes(1, 2)


def test_the_root_and_the_joints_are_where_the_actor_is(tiny):
    matrices = matrices_of(frame(tiny), 1)
    pose = cast(tiny).pose.take(1)
    local = world_from_local(tiny.skeleton, pose)
    root = [[0, 0, 1, 3], [0, 1, 0, 0], [-1, 0, 0, 4], [0, 0, 0, 1]]  # a quarter turn to the left
    assert matrices[0] == pytest.approx(np.array(root), abs=1e-6)
    assert matrices[1:, :3] == pytest.approx((root @ matrix_4(local))[:, :3], abs=1e-5)


def matrix_4(matrices):
    """(J,4,4) of (J,3,4)."""
    return np.concatenate([matrices, np.tile([[[0, 0, 0, 1]]], (len(matrices), 1, 1))], axis=1)


def test_normals_turn_with_the_actor(tiny):
    shown = read_model(frame(tiny), "frame")
    x, y, z = tiny.vertices(cast(tiny).pose.take(1))[0].normals.T
    assert shown.vertices(shown.bind_pose)[1].normals == pytest.approx(np.stack([z, y, -x], axis=1), abs=1e-5)


def test_the_json_keeps_its_length_and_layout(tiny):
    template = FrameTemplate([(tiny, 2)])
    frames = [
        template.frame(tick, "ab", [cast(tiny, PLACES * scale)])
        for tick, scale in ((0, 0), (4_000_000_000, -1e6))
    ]
    left, right = (json.loads(json_of(data)) for data in frames)
    assert len(json_of(frames[0])) == len(json_of(frames[1]))
    assert (left["bufferViews"], left["nodes"], left["meshes"]) == (
        right["bufferViews"],
        right["nodes"],
        right["meshes"],
    )


def test_tick_and_hash_are_in_the_frame(tiny):
    assert json.loads(json_of(frame(tiny, tick=77)))["asset"]["extras"] == {
        "hash": "00000000000000ff",
        "tick": 77,
    }


def test_the_same_state_gives_the_same_bytes(tiny):
    assert frame(tiny) == frame(tiny)


def test_every_actor_is_a_node_with_mesh_nodes_below(tiny):
    nodes = json.loads(json_of(frame(tiny)))["nodes"]
    assert [(node["name"], node.get("children")) for node in nodes if "children" in node] == [
        ("tiny 1", [1]),
        ("tiny 2", [3]),
    ]


@pytest.mark.parametrize("name", ["%d", "100 %s", '"quoted"', "@number", "ü"])
def test_names_cannot_disturb_the_layout(name):
    shown = read_model(frame(read_model(changed("/nodes/2/name", name), name)), "frame")
    assert name in shown.skeleton.names


def test_a_pose_that_overflows_stays_finite(tiny):
    huge = cast(tiny)
    huge = huge._replace(pose=huge.pose._replace(scale=np.full_like(huge.pose.scale, 1e30)))
    with np.errstate(over="ignore", invalid="ignore"):
        data = FrameTemplate([(tiny, 2)]).frame(1, "", [huge])
    json.loads(json_of(data))
    assert np.isfinite(matrices_of(data, 0)).all()


def test_bounds_are_those_of_the_vertices(tiny):
    told = [accessor for accessor in json.loads(json_of(frame(tiny)))["accessors"] if "min" in accessor]
    shown = read_model(frame(tiny), "frame")
    parts = shown.vertices(shown.bind_pose)
    assert [a["min"] + a["max"] for a in told] == [
        pytest.approx([*part.positions.min(axis=0), *part.positions.max(axis=0)], rel=1e-6) for part in parts
    ]


def test_a_pose_of_another_skeleton_is_refused(tiny):
    short = cast(tiny)
    short = short._replace(pose=Pose(*(array[:, :-1] for array in short.pose)))
    with pytest.raises(ValueError):
        FrameTemplate([(tiny, 2)]).frame(1, "", [short])


def test_frames_that_are_made_at_the_same_time_do_not_mix(tiny):
    template = FrameTemplate([(tiny, 2)])
    casts = [cast(tiny, PLACES * scale) for scale in range(8)]
    alone = [template.frame(1, "", [one]) for one in casts]
    with ThreadPoolExecutor(8) as threads:
        assert list(threads.map(lambda one: template.frame(1, "", [one]), casts * 4)) == alone * 4


def test_an_empty_stage_is_a_valid_file():
    assert khronos.errors(FrameTemplate([]).frame(1, "", [])) == []


@pytest.fixture(scope="module")
def sources_warnings():
    """The kinds of warnings that the validator has for the models themselves."""
    models = {name: character(name).model_glb for name in MODELS}
    return {
        name: kinds(report, 1) for name, report in zip(models, khronos.issues(*models.values()), strict=True)
    }


@pytest.fixture(scope="module", params=[False, True], ids=["stream", "with images"])
def reports_of_frames(request):
    return dict(
        zip(
            MODELS,
            khronos.issues(*(frame(character(name), images=request.param) for name in MODELS)),
            strict=True,
        )
    )


def kinds(report, severity):
    return {message["code"] for message in report["messages"] if message["severity"] == severity}


@pytest.mark.parametrize("name", MODELS)
def test_the_validator_finds_no_error_and_no_new_kind_of_warning(reports_of_frames, sources_warnings, name):
    assert kinds(reports_of_frames[name], 0) == set()
    assert kinds(reports_of_frames[name], 1) <= sources_warnings[name]


@needs_assets
def test_frames_of_several_casts_have_no_error_in_motion():
    sources = [character("RobotExpressive.glb"), character("KayKit_Knight.glb"), character("CesiumMan.glb")]
    template = FrameTemplate([(source, 2) for source in sources], images=True)
    frames = [
        template.frame(tick, "f" * 16, [cast(source, PLACES * tick) for source in sources])
        for tick in range(4)
    ]
    assert khronos.errors(*frames) == []


@needs_assets
def test_images_are_left_out_of_the_stream():
    knight = character("KayKit_Knight.glb")
    assert "images" not in json.loads(json_of(frame(knight)))
    assert json.loads(json_of(frame(knight, images=True)))["materials"][0]["pbrMetallicRoughness"][
        "baseColorTexture"
    ] == {"index": 0}


def share_facing_out(part):
    """The share of triangles whose corners run round the normals of their vertices, as seen from outside."""
    faces = (np.arange(len(part.positions)) if part.indices is None else part.indices).reshape(-1, 3)
    a, b, c = part.positions.astype(float)[faces].swapaxes(0, 1)
    return np.mean(np.sum(np.cross(b - a, c - a) * part.normals[faces].sum(axis=1), axis=1) > 0)


@needs_assets
@pytest.mark.parametrize("name", ["Node_NegativeScale_02", "Node_NegativeScale_08", "Node_NegativeScale_12"])
def test_triangles_of_mirrored_parts_still_face_outwards(name):
    shown = read_model(frame(character(f"AssetGenerator/Node_NegativeScale/{name}.gltf")), "frame")
    assert min(share_facing_out(part) for part in shown.parts) > 0.95
