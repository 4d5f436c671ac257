"""The camera of a recording: it frames one of its actors, and follows it (glTF 2.0, 3.10)."""

from __future__ import annotations

import numpy as np

from statwalk.character.staging import staging
from statwalk.files.gltf.keys import reduce_keys
from statwalk.files.gltf.recording_draft import Recorded, RecordingDraft, add_property, new_node
from statwalk.machine.definition.framing import Framing

NEAR_ENOUGH = 1e-3
"""metres between the camera and its place, at most"""


def add_camera(draft: RecordingDraft, actor: Recorded, framing: Framing) -> None:
    """Adds a camera that frames an actor as it stands at its first tick, and follows its path."""
    camera = staging(
        actor.character,
        actor.poses.take(0),
        actor.root_position,
        framing,
        heading=float(actor.heading[0]),
        rate=draft.rate,
    )
    lens = {"yfov": camera.field, "znear": camera.near, "zfar": camera.far}
    draft.cameras.append({"name": framing, "type": "perspective", "perspective": lens})
    node = new_node(draft, {"name": "camera", "camera": 0, "rotation": camera.rotation.tolist()})
    draft.roots.append(node)
    keys = reduce_keys(camera.position[:, None], np.array([NEAR_ENOUGH]))[0]
    add_property(draft, actor, node, "translation", camera.position, keys)
