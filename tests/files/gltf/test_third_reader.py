"""pygltflib reads posed frames, and finds the vertices where statwalk puts them, with the actor's place and
heading.
"""

import numpy as np
import pygltflib
import pytest
from paths import ASSETS
from reference_poses import character
from statwalk.files.gltf.template import FrameTemplate, PosedCast, stage_worlds

PLACE, HEADING = np.array([[1.5, 0.0, -2.0]]), np.array([0.7])
SHARED = ["RobotExpressive.glb", "KayKit_Knight.glb", "CesiumMan.glb", "BoxAnimated.glb"]
NAMES = (
    SHARED if ASSETS.is_dir() else ["faq-walker/walker.glb", "swarm/bee/bee.glb", "playground/door/door.glb"]
)


def positions(data: bytes) -> np.ndarray:
    """(V, 3) of all primitives; the nodes of a frame stand still, so these are the stage's."""
    document = pygltflib.GLTF2.load_from_bytes(data)
    found = []
    for primitive in (primitive for mesh in document.meshes for primitive in mesh.primitives):
        accessor = document.accessors[primitive.attributes.POSITION]
        view = document.bufferViews[accessor.bufferView]
        start = (view.byteOffset or 0) + (accessor.byteOffset or 0)
        found.append(np.frombuffer(document.binary_blob(), "<f4", 3 * accessor.count, start).reshape(-1, 3))
    return np.concatenate(found)


@pytest.mark.parametrize("name", NAMES)
def test_pygltflib_finds_a_frames_vertices(name):
    source = character(name)
    posed = PosedCast(next(iter(source.clips.values())).sample(np.array([0.3])), PLACE, HEADING)
    data = FrameTemplate([(source, 1)]).frame(1, "0" * 16, [posed])
    parts = source.surface.posed_parts(stage_worlds(source, posed)[0], posed.pose.weights[0])
    wanted = np.concatenate([part.positions for part in parts])
    np.testing.assert_allclose(np.sort(positions(data), axis=0), np.sort(wanted, axis=0), atol=1e-5)
