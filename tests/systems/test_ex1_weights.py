"""EX1: expressions read and set the weights of morph targets, by the names that a glTF file gives them."""

from dataclasses import replace

import numpy as np
import pytest
import statwalk
from statwalk.character.role import Role
from statwalk.errors import ContentError, MachineError
from statwalk.files.chunk import read_chunk_file, write_chunk_file
from statwalk.files.gltf.read import read_model
from statwalk.files.gltf.write import model_glb
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.definition.expression_lines import read_lines
from support.tiny_model import document, glb
from systems.test_ex1 import played

HEAD = """\
character: c.glb
initial: T
parameters: {smile: {default: 0.25, min: 0, max: 1}}
expressions: |
  {lines}
states: {T: {motion: Bend}}
table: |
  state | END
  T     |
"""


def smiler(name="Smile", **mesh):
    """The tiny model, whose one morph target lifts all points by 1 m along Z; 0.5 at rest."""
    root, binary = document()
    root["meshes"][0] |= {"extras": {"targetNames": [name]}} | mesh
    return read_model(glb(root, binary), "smiler")


def role(*lines, character=None):
    text = HEAD.replace("{lines}", "\n  ".join(lines))
    return Role.build("smiler", character or smiler(), read_machine(text))


def test_a_parameter_drives_a_morph_target():
    stage, actor = played(role("Smile.weight = 2 * smile"), 1)
    assert actor.pose.weights.tolist() == [0.5]
    stage.set(actor, "smile", 0.375)
    stage.step(1)
    assert actor.pose.weights.tolist() == [0.75]
    assert actor.channels == {"Smile.weight": 0.75}


def test_what_a_line_reads_is_the_weight_of_the_motion():
    _, actor = played(role("double = 2 * Smile.weight"), 1)
    assert actor.variables == {"double": 1.0}
    assert actor.pose.weights.tolist() == [0.5]


def test_targets_of_one_name_in_several_meshes_are_set_together():
    root, binary = document()
    root["meshes"][0]["extras"] = {"targetNames": ["Smile"]}
    root["nodes"].append({"name": "twin", "mesh": 0, "skin": 0})
    root["scenes"][0]["nodes"].append(3)
    twins = read_model(glb(root, binary), "twins")
    assert twins.targets == {"Smile": (0, 1)}
    shown = statwalk.express(twins, "Smile.weight = 0.125")
    assert shown.pose.weights.tolist() == [0.125, 0.125]


def test_a_weight_may_move_the_vertices():
    character = smiler()
    shown = statwalk.express(character, "Smile.weight = 0.125")
    assert shown.channels == {"Smile.weight": 0.125}
    lifted, rest = (character.vertices(pose)[0].positions for pose in (shown.pose, character.bind_pose))
    np.testing.assert_allclose((rest - lifted)[0], [0, 0, 0.375], atol=1e-6)


def test_a_target_without_a_name_has_a_number():
    for character in (smiler(None), smiler(extras=[1]), smiler(extras={"targetNames": "Smile"})):
        assert list(character.targets) == ["target_0"]
    assert statwalk.express(smiler(""), "target_0.weight = 1").pose.weights.tolist() == [1]


@pytest.mark.parametrize(
    ("line", "what"),
    [
        ("Smil.weight = 1", r"no morph target is called 'Smil'; did you mean Smile.? There are: Smile"),
        ("a = hip.weight", "no morph target is called 'hip'"),
        (
            "Smile.weigh = 1",
            r"'Smile.weigh' has no channel 'weigh'; did you mean weight. There are: rotate_x.*, weight",
        ),
    ],
)
def test_an_unknown_name_is_refused_with_its_line(line, what):
    with pytest.raises((MachineError, ContentError), match=what) as refused:
        role("a1 = 1", line)
    assert refused.value.place == "line 6"
    with pytest.raises(ContentError, match=what):
        statwalk.express(smiler(), line)


@pytest.mark.parametrize("again", [model_glb, write_chunk_file], ids=["glTF", "chunk"])
def test_the_names_and_lines_survive_in_a_file(again):
    character = replace(smiler("Big smile"), expressions=read_lines([(1, "'Big smile'.weight = 0.75")], ()))
    read = read_chunk_file if again is write_chunk_file else read_model
    second = read(again(character), "again")
    assert second.targets == {"Big smile": (0,)}
    assert statwalk.express(second).pose.weights.tolist() == [0.75]
