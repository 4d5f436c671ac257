"""What states play and layers move, as roles are built."""

import gaits
import pytest
from statwalk.character.motions import masks_of
from statwalk.files.gltf import read_model
from statwalk.machine.definition.machine_definition import (
    LayerDefinition,
    MachineDefinition,
    StateDefinition,
)
from statwalk.motion.blend_space import BlendSpace
from tiny_model import model

TINY = read_model(model(), "tiny")
STATES = {"STAND": StateDefinition("stand", 1)}


def mask_of(*names):
    layer = LayerDefinition({}, "", 1, mask=names)
    return masks_of(TINY, MachineDefinition("tiny", STATES, "STAND", layers={"one": layer}))[1]


@pytest.mark.parametrize(
    ("names", "joints", "weights"), [(("hip",), [0, 1], []), (("skin",), [2], [0]), ((), [0, 1, 2], [0])]
)
def test_a_mask_takes_joints_with_all_below_and_the_morphs_of_their_meshes(names, joints, weights):
    mask = mask_of(*names)
    assert (mask.joints.tolist(), mask.weights.tolist()) == (joints, weights)


def test_a_clip_is_made_once():
    motions = gaits.role().motions
    assert isinstance(motions[1], BlendSpace)
    other = gaits.role(("STAND: {motion: stand", "STAND: {motion: walk")).motions
    assert other[0] is other[1].motions[0]


def test_the_first_clip_of_a_blend_has_the_markers_of_its_state():
    assert gaits.role().motions[1].marks[0] == (("left", 0.0), ("right", 0.5))


def test_only_the_base_travels():
    still = (
        ("walk: 1.2, run: 4", "stand: 1.2, nod: 4"),
        ("walk: {left: 0, right: 0.5}, run: {left: 0.2, right: 0.62}", ""),
    )
    assert gaits.role().travels
    assert not gaits.role(*still, ("WAVE: {motion: wave, loop", "WAVE: {motion: walk, loop")).travels
