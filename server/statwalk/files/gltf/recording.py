"""Writes a piece of a stage's history as an animated .glb: the poses of every actor from tick to tick, and
the actor's path (glTF 2.0, 3.11).

The poses are the stage's own, at their ticks, without resampling. Keys that interpolation restores are
dropped: at no tick is a joint further than 0.5 mm from its position in the stage, nor rotated relative to its
parent by more than 0.0002 rad (0.01°).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from statwalk.character.character import Character
from statwalk.files.gltf import container, json_text
from statwalk.files.gltf.builder import GENERATOR, Builder
from statwalk.files.gltf.check import Json
from statwalk.files.gltf.keys import Keys, reduce_keys
from statwalk.files.gltf.materials import extensions_used, with_textures_from
from statwalk.files.gltf.recording_camera import add_camera
from statwalk.files.gltf.recording_draft import (
    Recorded,
    RecordingDraft,
    Shared,
    add_channel,
    add_property,
    new_node,
)
from statwalk.files.gltf.textures import add_textures
from statwalk.files.gltf.world_keys import PROPERTIES, SHARE, WorldKeys
from statwalk.files.gltf.write import MeshKey, grouped, matrix_columns, primitive_entry
from statwalk.machine.definition.framing import Framing
from statwalk.maths import quat
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.rig.evaluate import world_from_local
from statwalk.rig.skeleton import Skeleton
from statwalk.skin.primitive import Primitive, Skin

UP = np.array([0, 1, 0], np.float64)


def recording_glb(
    actors: Sequence[Recorded],
    rate: float,
    checkpoint: Callable[[], None] = lambda: None,
    camera: tuple[Recorded, Framing] | None = None,
) -> bytes:
    """Returns the actors with their motion as a GLB, `rate` ticks a second; time 0 is tick 0.

    Each actor is a node that follows the actor's path, with the skeleton below. Actors of one character share
    meshes, materials and textures. `camera`: the actor that a camera follows, and its framing.
    `checkpoint` is called several times for each actor; an exception in it ends the work.
    """
    draft = RecordingDraft(rate, checkpoint)
    for actor in actors:
        _add_actor(draft, actor)
    if camera:
        add_camera(draft, *camera)
    animations = (
        [{"name": "recording", "samplers": draft.samplers, "channels": draft.channels}] if actors else []
    )
    root: Json = {
        "asset": {"version": "2.0", "generator": GENERATOR},
        "extensionsUsed": extensions_used([*draft.materials, *draft.resources["textures"]]),
        "nodes": draft.nodes,
        "meshes": draft.meshes,
        "skins": draft.skins,
        "cameras": draft.cameras,
        "materials": draft.materials,
        "animations": animations,
        **draft.resources,
    }
    if draft.nodes:
        root |= {"scene": 0, "scenes": [{"nodes": draft.roots}]}
    return container.join(json_text.dumps(draft.builder.finished(root)), bytes(draft.builder.binary))


def _add_actor(draft: RecordingDraft, actor: Recorded) -> None:
    """Adds an actor: the node that follows its path, its joints below in their order, and its meshes."""
    character = actor.character
    root = new_node(draft, {"name": actor.name})
    draft.roots.append(root)
    first = len(draft.nodes)
    for name, parent in zip(character.skeleton.names, character.skeleton.parent.tolist(), strict=True):
        parent_node = draft.nodes[first + parent if parent >= 0 else root]
        parent_node.setdefault("children", []).append(new_node(draft, {"name": name}))
    _place_meshes(draft, actor, first)
    _add_motion(draft, actor, [root, *range(first, first + len(character.skeleton))])


def _add_motion(draft: RecordingDraft, actor: Recorded, nodes: Sequence[int]) -> None:
    """Adds the channels of the actor's `nodes`: the node that follows its path, then its joints.

    The path's first and last positions are always keys: they set the length of the recording.
    """
    skeleton, poses = with_root_joint(actor)
    kept = WorldKeys(skeleton, poses, np.append(1.0, _parent_sizes(actor.character)), draft.checkpoint).kept
    ends = np.union1d(kept["translation"][0].ticks, [0, len(poses.scale) - 1])
    add_channel(
        draft,
        actor,
        nodes[0],
        "translation",
        poses.translation[:, 0],
        Keys(ends, kept["translation"][0].interpolation),
    )
    for path in PROPERTIES:
        for row, (node, keys) in enumerate(zip(nodes, kept[path], strict=True)):
            if row or path != "translation":
                add_property(draft, actor, node, path, getattr(poses, path)[:, row], keys)


def with_root_joint(actor: Recorded) -> tuple[Skeleton, Pose]:
    """Returns the actor's skeleton and poses (T,1 + J,…) with one more joint above all others, which has the
    actor's position and heading.
    """
    skeleton, poses = actor.character.skeleton, actor.poses
    heading = quat.from_axis_angle(UP, np.asarray(actor.heading, np.float64))
    pose = Pose(
        np.concatenate([np.asarray(actor.root_position, np.float64)[:, None], poses.translation], axis=1),
        np.concatenate([heading[:, None], poses.rotation], axis=1),
        np.concatenate([np.ones((len(heading), 1, 3)), poses.scale], axis=1),
        poses.weights,
    )
    return Skeleton((actor.name, *skeleton.names), np.append(-1, skeleton.parent + 1).astype(np.int32)), pose


def _parent_sizes(character: Character) -> Floats:
    """Returns (J,): the length in metres, in the stage, of one unit of each joint's translation, at rest."""
    world = world_from_local(character.skeleton, character.bind_pose)[..., :3].astype(np.float64)
    size = np.sqrt((world**2).sum(axis=-2)).max(axis=-1)
    parent = character.skeleton.parent
    return np.maximum(np.where(parent < 0, 1.0, size[parent]), 1e-9)


def _place_meshes(draft: RecordingDraft, actor: Recorded, first: int) -> None:
    """Adds each mesh of an actor once, on a node of its own kind, with the weights of its morph targets."""
    character = actor.character
    if id(character) not in draft.shared:
        draft.shared[id(character)] = add_shared(draft, character)
    shared = draft.shared[id(character)]
    skins = [
        _add_skin(draft, skin, matrices, first)
        for skin, matrices in zip(character.skins, shared.matrices, strict=True)
    ]
    used: set[tuple[int, MeshKey]] = set()
    for part in character.parts:
        key = (part.mesh, part.skin)
        if (part.node, key) not in used:
            used.add((part.node, key))
            node = (
                _rigid_node(draft, first + part.joint)
                if part.skin is None
                else _skinned_node(draft, actor.name, skins[part.skin])
            )
            draft.nodes[node]["mesh"] = shared.meshes[key]
            _add_weights(draft, actor, node, part)


def _rigid_node(draft: RecordingDraft, joint: int) -> int:
    """Returns a node for a rigid mesh: the joint's own, or a new one below if the joint already has a
    mesh.
    """
    if "mesh" not in draft.nodes[joint]:
        return joint
    mesh_node = new_node(draft, {"name": f"{draft.nodes[joint]['name']} mesh"})
    draft.nodes[joint].setdefault("children", []).append(mesh_node)
    return mesh_node


def _skinned_node(draft: RecordingDraft, name: str, skin: int) -> int:
    """Adds a node for a skinned mesh, at the root: only its joints move it, no transform of a node
    (3.7.3.3).
    """
    node = new_node(draft, {"name": f"{name} skin {skin}", "skin": skin})
    draft.roots.append(node)
    return node


def _add_weights(draft: RecordingDraft, actor: Recorded, node: int, part: Primitive) -> None:
    """Adds the morph weights of a mesh's node."""
    if part.target_positions is not None:
        values = actor.poses.weights[:, part.weight_first : part.weight_first + len(part.target_positions)]
        add_property(
            draft, actor, node, "weights", values, reduce_keys(values[:, None], np.array([SHARE]))[0]
        )


def add_shared(draft: RecordingDraft, character: Character) -> Shared:
    """Adds the meshes, materials and textures of a character; its actors share them."""
    first = len(draft.materials)
    first_texture = add_textures(draft.builder, draft.resources, character)
    draft.materials += [with_textures_from(material, first_texture) for material in character.materials]
    meshes: dict[MeshKey, int] = {}
    for key, parts in grouped(character.parts).items():
        meshes[key] = len(draft.meshes)
        draft.meshes.append({"primitives": [_mesh_primitive(draft.builder, part, first) for part in parts]})
    return Shared(meshes, [draft.builder.array(matrix_columns(skin)) for skin in character.skins])


def _mesh_primitive(builder: Builder, part: Primitive, first_material: int) -> Json:
    """Returns a primitive with its material's index in the recording."""
    entry = primitive_entry(builder, part)
    return {**entry, "material": entry["material"] + first_material} if "material" in entry else entry


def _add_skin(draft: RecordingDraft, skin: Skin, matrices: int, first: int) -> int:
    """Adds a skin for one actor's joints; returns the skin's index."""
    draft.skins.append(
        {"name": skin.name, "joints": (first + skin.joints).tolist(), "inverseBindMatrices": matrices}
    )
    return len(draft.skins) - 1
