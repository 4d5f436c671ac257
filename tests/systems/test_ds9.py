"""DS9 facial animation (FAQ Q35): muscles whose vertices move along cubic paths of a contraction 0…1, that
add up, and named expressions that are keyed, blended, and states of a layer.

The positions of vertices are compared with NumPy's polynomials and Bernstein's form of the paths.
"""

import re

import numpy as np
import pytest
import statwalk
from statwalk.character.role import Role
from statwalk.errors import ContentError, MachineError
from statwalk.files.chunk import read_chunk_file, write_chunk_file
from statwalk.files.gltf.read import read_model
from statwalk.files.machine_yaml.machine_file import read_machine
from support.tiny_model import document, glb
from systems.test_ex1 import played

FACE = """\
model: tiny.glb
muscles:
  pull: {to: [1, 0, 0], radius: 0.5, path: [[0.1, 0, 0], [0.2, 0.3, 0], [0.3, 0.3, 0.2]]}
  lift: {to: [[1, 0, 0], [0, 1, 0]], radius: 0.5, path: [[0, 0, 0.4]]}
faces:
  smile: {pull: 0.8, lift: 0.5}
  sulk: {lift: 1}
clips:
  greet: {faces: {0: {}, 0.5: smile, 1: {smile: 0.5, pull: 0.1}}}
"""
MACHINE = """\
character: c.yaml
initial: REST
states: {REST: {motion: Bend, loop: true}}
table: |
  state | END
  REST  |
layers:
  face:
    mask: [muscles]
    initial: NEUTRAL
    states: {NEUTRAL: {motion: none}, SMILE: {motion: smile}, SULK: {motion: sulk}}
    table: |
      state   | NEUTRAL | SMILE | SULK
      NEUTRAL | -       | SMILE | SULK
      SMILE   | NEUTRAL | -     | SULK
      SULK    | NEUTRAL | SMILE | -
defaults: {when: now, blend: 0.3, buffer: 0.3}
"""
PATH = np.array([[0, 0, 0], [0.1, 0, 0], [0.2, 0.3, 0], [0.3, 0.3, 0.2]])
AT_REST = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]])


def rigid_triangle():
    """The tiny model without skin and morph target: points (0,0,0), (1,0,0), (0,1,0)."""
    root, binary = document()
    (primitive,) = root["meshes"][0]["primitives"]
    del primitive["targets"], root["meshes"][0]["weights"], root["nodes"][2]["skin"], root["skins"]
    for name in ("JOINTS_0", "WEIGHTS_0"):
        del primitive["attributes"][name]
    root["materials"] = [{"name": "skin"}]
    primitive["material"] = 0
    return glb(root, binary)


def face(folder, text=FACE):
    (folder / "tiny.glb").write_bytes(rigid_triangle())
    (folder / "face.yaml").write_text(text)
    return statwalk.load(folder / "face.yaml")


def points(character, **contractions):
    lines = [f"{name}.weight = {value}" for name, value in contractions.items()]
    (part,) = character.vertices(statwalk.express(character, lines).pose)
    return part.positions


def on_path(contraction):
    """Bernstein's form of the cubic."""
    c = contraction
    return np.array([(1 - c) ** 3, 3 * c * (1 - c) ** 2, 3 * c * c * (1 - c), c**3]) @ PATH


@pytest.mark.parametrize("contraction", [0, 0.25, 1 / 3, 0.6, 1])
def test_a_vertex_moves_along_the_cubic_path_of_the_contraction(tmp_path, contraction):
    moved = points(face(tmp_path), pull=contraction)
    powers = np.stack(
        [np.polyfit([0, 0.3, 0.7, 1], [on_path(c)[k] for c in (0, 0.3, 0.7, 1)], 3) for k in range(3)]
    )
    expected = [np.polyval(row, contraction) for row in powers]
    np.testing.assert_allclose(moved[1] - AT_REST[1], expected, atol=1e-6)
    np.testing.assert_allclose(moved[[0, 2]], AT_REST[[0, 2]], atol=1e-6)  # farther than the radius


def test_muscles_add_up(tmp_path):
    moved = points(face(tmp_path), pull=0.6, lift=0.5)
    np.testing.assert_allclose(moved[1], AT_REST[1] + on_path(0.6) + (0, 0, 0.2), atol=1e-6)
    np.testing.assert_allclose(moved[2], AT_REST[2] + (0, 0, 0.2), atol=1e-6)  # `lift` is a line through both


def test_the_share_falls_smoothly_with_the_distance(tmp_path):
    text = FACE.replace("to: [1, 0, 0], radius: 0.5", "to: [1, 0.3, 0], radius: 0.5")
    moved = points(face(tmp_path, text), pull=1)
    np.testing.assert_allclose(moved[1] - AT_REST[1], (1 - 0.6**2) ** 2 * PATH[3], atol=1e-6)


def test_a_contraction_is_0_to_1(tmp_path):
    character = face(tmp_path)
    np.testing.assert_array_equal(points(character, pull=3), points(character, pull=1))
    np.testing.assert_array_equal(points(character, pull=-1), points(character, pull=0))


def test_normals_turn_with_the_surface(tmp_path):
    character = face(tmp_path)
    (part,) = character.vertices(statwalk.express(character, "pull.weight = 1").pose)
    a, b, c = part.positions
    across = np.cross(b - a, c - a)
    np.testing.assert_allclose(part.normals, np.tile(across / np.linalg.norm(across), (3, 1)), atol=1e-5)


def test_named_expressions_are_clips_and_are_keyed(tmp_path):
    character = face(tmp_path)
    smile = character.clip("smile").sample(0)
    assert smile.weights == pytest.approx([0.8, 0.64, 0.512, 0.5])
    greet = character.clip("greet")
    assert greet.duration == 1
    assert greet.sample(0.5).weights == pytest.approx([0.8, 0.64, 0.512, 0.5])
    assert greet.sample(1).weights == pytest.approx([0.5, 0.25, 0.125, 0.25])  # 0.5 of the smile, and 0.1


def role(folder, machine=MACHINE):
    return Role.build("face", face(folder), read_machine(machine))


def test_events_blend_contractions_and_their_powers_follow(tmp_path):
    stage, actor = played(role(tmp_path), 5)
    assert actor.pose.weights == pytest.approx([0, 0, 0, 0])
    stage.send(actor, "SMILE")
    seen = []
    for _ in range(20):
        stage.step(1)
        once, twice, thrice, _ = actor.pose.weights.astype(float)
        assert (twice, thrice) == pytest.approx((once**2, once**3), abs=1e-6)
        seen.append(once)
    assert seen == sorted(seen)
    assert 0.2 < seen[8] < 0.6  # after 0.15 s of 0.3 s
    assert actor.pose.weights == pytest.approx([0.8, 0.64, 0.512, 0.5], abs=1e-6)
    stage.send(actor, "SULK")
    stage.step(30)
    assert actor.pose.weights == pytest.approx([0, 0, 0, 1], abs=1e-6)
    stage.send(actor, "NEUTRAL")
    stage.step(30)
    assert actor.pose.weights == pytest.approx([0, 0, 0, 0], abs=1e-6)


def test_the_layer_leaves_the_joints_to_the_base(tmp_path):
    stage, actor = played(role(tmp_path), 40)
    other, bare = played(role(tmp_path, MACHINE), 1)
    stage.send(actor, "SMILE")
    stage.step(10)
    other.step(49)
    np.testing.assert_array_equal(actor.pose.rotation, bare.pose.rotation)


def test_expressions_of_a_machine_set_contractions(tmp_path):
    text = MACHINE.replace("layers:", "expressions: pull.weight = 5 * (frameid > 3)\nlayers:")
    stage, actor = played(role(tmp_path, text), 3)
    assert actor.pose.weights.tolist() == [0, 0, 0, 0]
    stage.step(1)
    assert actor.pose.weights.tolist() == [1, 1, 1, 0]


@pytest.mark.parametrize("way", ["glTF", "chunk"])
def test_muscles_and_faces_survive_in_a_file(tmp_path, way):
    character = face(tmp_path)
    read = read_chunk_file if way == "chunk" else read_model
    again = read(write_chunk_file(character) if way == "chunk" else character.model_glb, "again")
    assert (again.notes, again.muscles, again.faces) == ((), character.muscles, character.faces)
    np.testing.assert_array_equal(points(again, pull=0.6), points(character, pull=0.6))
    assert again.clip("greet").sample(1).weights == pytest.approx([0.5, 0.25, 0.125, 0.25])


def test_a_muscle_without_its_targets_is_left_out_with_a_note(tmp_path):
    model = face(tmp_path).model_glb.replace(b'"pull.2"', b'"push.2"')
    again = read_model(model, "again")
    assert again.muscles == {}
    assert re.search("extras.statwalk is left out: .*pull.2", again.notes[0])


@pytest.mark.parametrize(
    ("old", "new", "line", "what"),
    [
        ("radius: 0.5, path: [[0, 0", "radius: 0.5, push: [[0, 0", 4, "no key is called 'push'"),
        ("radius: 0.5, path: [[0, 0, 0.4]]", "radius: 0.5", 4, "a muscle needs `to`"),
        ("radius: 0.5, path: [[0, 0", "radius: 0, path: [[0, 0", 4, "not a finite number from 1e-06"),
        ("[[0, 0, 0.4]]", "[[0, 0]]", 4, "a point is"),
        ("[[0, 0, 0.4]]", "[[0, 0, 1], [0, 0, 2], [0, 0, 3], [0, 0, 4]]", 4, "1 to 3 points"),
        ("to: [1, 0, 0]", "to: [9, 0, 0]", 3, "pull moves no vertex: .*, and the nearest vertex is 8 m"),
        ("to: [1, 0, 0],", "to: [1, 0, 0], joint: Jaw,", 3, "no joint is called 'Jaw'"),
        ("to: [1, 0, 0],", "to: [1, 0, 0], material: skim,", 3, "'skim'; did you mean skin"),
        ("to: [1, 0, 0],", "to: [1, 0, 0], mirror: lift,", 4, "the muscle lift is there twice"),
        ("  pull:", "  pull.2:", 3, "does not end in .2 or .3"),
        ("lift: 1}", "lift: 1.5}", 7, "'1.5' is not a finite number from 0 to 1"),
        ("lift: 1}", "lit: 1}", 7, "no muscle or face is called 'lit'; did you mean lift"),
        ("0.5: smile", "0.5: smil", 9, "no face is called 'smil'; did you mean smile"),
        ("1: {smile", "0.2: {smile", 9, "the times of keys rise"),
        ("  sulk:", "  Bend:", 6, "a clip Bend already"),
        ("model: tiny.glb", "skeleton: mammal", 3, "`muscles` are for a character with a model"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_refused_with_its_line(tmp_path, old, new, line, what):
    with pytest.raises(ContentError, match=what) as refused:
        face(tmp_path, FACE.replace(old, new))
    assert refused.value.place == f"line {line}"


def test_a_mask_names_a_muscle_or_all_of_them(tmp_path):
    assert role(tmp_path).masks[1].weights.tolist() == [0, 1, 2, 3]
    assert role(tmp_path).masks[1].joints.tolist() == []
    one = role(tmp_path, MACHINE.replace("[muscles]", "[lift.weight]"))
    assert one.masks[1].weights.tolist() == [3]
    with pytest.raises(MachineError, match="mask: no joint is called 'muscle'"):
        role(tmp_path, MACHINE.replace("[muscles]", "[muscle]"))


@pytest.mark.parametrize("name", ["smile", "grin", "surprise", "frown", "anger"])
def test_the_shipped_face_shows_the_faqs_expressions(name):
    machine = statwalk.load("face")
    stage, actor = played(machine, 5)
    stage.send(actor, name.upper())
    stage.step(40)
    for muscle in machine.character.muscles:
        (column,) = {actor.pose.weights[c] for c in machine.character.targets[muscle]}
        assert column == pytest.approx(machine.character.faces[name].get(muscle, 0), abs=1e-6)


def test_a_smile_raises_the_corners_of_the_mouth_and_a_frown_lowers_them():
    character = statwalk.load("face").character
    (skin,) = [
        row
        for row, part in enumerate(character.parts)
        if part.material is not None and character.materials[part.material]["name"] == "skin"
    ]
    rest = character.vertices(character.bind_pose)[skin].positions
    corner = np.linalg.norm(rest - (0.025, 0.2135, 0.09), axis=1).argmin()
    shown = {
        name: character.vertices(character.clip(name).sample(0))[skin].positions[corner, 1]
        for name in character.faces
    }
    assert shown["smile"] > rest[corner, 1] + 0.005
    assert shown["frown"] < rest[corner, 1] - 0.005
