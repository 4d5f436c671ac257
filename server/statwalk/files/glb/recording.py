"""A piece of a stage as one .glb with its animation: every actor's poses from tick to tick, and the way it went (glTF 2.0, 3.11).

The poses are keys as they are, at their ticks, nothing resampled. Keys that lines between others bring back are dropped: at no tick is a
joint then further than 0.5 mm from its place in the stage, nor turned beside its parent by more than 0.0002 rad (0.01°).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal, NamedTuple

import numpy as np
import orjson
from numpy.typing import NDArray

from statwalk.character import Character
from statwalk.files.glb import container
from statwalk.files.glb.builder import GENERATOR, Builder
from statwalk.files.glb.check import Json
from statwalk.files.glb.keys import Keys, needed
from statwalk.files.glb.materials import extensions_used, moved
from statwalk.files.glb.textures import Resources, add_textures, no_resources
from statwalk.files.glb.worldkeys import PROPERTIES, SHARE, Property, WorldKeys
from statwalk.files.glb.write import MeshKey, grouped, matrix_columns, primitive_entry
from statwalk.maths import quat
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.rig.evaluate import world_from_local
from statwalk.rig.skeleton import Skeleton
from statwalk.skin.primitive import Primitive, Skin

UP = np.array([0, 1, 0], np.float64)
DEFAULTS = {"translation": (0, 0, 0), "rotation": (0, 0, 0, 1), "scale": (1, 1, 1)}


class Recorded(NamedTuple):
    """One actor over T ticks: local poses (T,J,…), places (T,3) in metres, headings (T,) in radians about +Y; `first` its first tick."""

    name: str
    character: Character
    poses: Pose
    root_position: Floats
    heading: Floats
    first: int = 0


class Shared(NamedTuple):
    """What all actors of one character have in common: indices of its meshes, and of its skins' matrices."""

    meshes: dict[MeshKey, int]
    matrices: list[int]


@dataclass
class Draft:
    """A recording while it is laid out."""

    rate: float
    builder: Builder = field(default_factory=Builder)
    nodes: list[Json] = field(default_factory=list)
    roots: list[int] = field(default_factory=list)
    meshes: list[Json] = field(default_factory=list)
    materials: list[Json] = field(default_factory=list)
    skins: list[Json] = field(default_factory=list)
    samplers: list[Json] = field(default_factory=list)
    channels: list[Json] = field(default_factory=list)
    resources: Resources = field(default_factory=no_resources)
    shared: dict[int, Shared] = field(default_factory=dict)
    times: dict[bytes, NDArray[np.float32]] = field(default_factory=dict)


def recording_glb(actors: Sequence[Recorded], rate: float) -> bytes:
    """The actors with their motion as a valid GLB, `rate` ticks a second; time 0 is tick 0.

    Each actor is a node that goes its way, its skeleton below. Actors of one character share meshes, materials and textures.
    """
    draft = Draft(rate)
    for actor in actors:
        add_actor(draft, actor)
    animations = [{"name": "recording", "samplers": draft.samplers, "channels": draft.channels}] if actors else []
    root: Json = {
        "asset": {"version": "2.0", "generator": GENERATOR},
        "extensionsUsed": extensions_used([*draft.materials, *draft.resources["textures"]]),
        "nodes": draft.nodes,
        "meshes": draft.meshes,
        "skins": draft.skins,
        "materials": draft.materials,
        "animations": animations,
        **draft.resources,
    }
    if draft.nodes:
        root |= {"scene": 0, "scenes": [{"nodes": draft.roots}]}
    return container.join(orjson.dumps(draft.builder.finished(root)), bytes(draft.builder.binary))


def add_actor(draft: Draft, actor: Recorded) -> None:
    """An actor: the node that goes its way, its joints below in their order, and its meshes."""
    character = actor.character
    root = new_node(draft, {"name": actor.name})
    draft.roots.append(root)
    first = len(draft.nodes)
    for name, parent in zip(character.skeleton.names, character.skeleton.parent.tolist(), strict=True):
        above = draft.nodes[first + parent if parent >= 0 else root]
        above.setdefault("children", []).append(new_node(draft, {"name": name}))
    place_meshes(draft, actor, first)
    add_motion(draft, actor, [root, *range(first, first + len(character.skeleton))])


def new_node(draft: Draft, node: Json) -> int:
    """A node; its index."""
    draft.nodes.append(node)
    return len(draft.nodes) - 1


def add_motion(draft: Draft, actor: Recorded, nodes: Sequence[int]) -> None:
    """The channels of the actor's `nodes`: the one that goes its way, then its joints. The way's first and last places are always keys:
    they say how long the recording is.
    """
    skeleton, poses = placed(actor)
    kept = WorldKeys(skeleton, poses, np.append(1.0, parent_sizes(actor.character))).kept
    ends = np.union1d(kept["translation"][0].ticks, [0, len(poses.scale) - 1])
    add_channel(draft, actor, nodes[0], "translation", poses.translation[:, 0], Keys(ends, kept["translation"][0].interpolation))
    for path in PROPERTIES:
        for row, (node, keys) in enumerate(zip(nodes, kept[path], strict=True)):
            if row or path != "translation":
                still_or_keys(draft, actor, node, path, getattr(poses, path)[:, row], keys)


def placed(actor: Recorded) -> tuple[Skeleton, Pose]:
    """The actor's skeleton and poses (T,1 + J,…) with a joint above all others: its place and heading."""
    skeleton, poses = actor.character.skeleton, actor.poses
    turn = quat.from_axis_angle(UP, np.asarray(actor.heading, np.float64))
    whole = Pose(
        np.concatenate([np.asarray(actor.root_position, np.float64)[:, None], poses.translation], axis=1),
        np.concatenate([turn[:, None], poses.rotation], axis=1),
        np.concatenate([np.ones((len(turn), 1, 3)), poses.scale], axis=1),
        poses.weights,
    )
    return Skeleton((actor.name, *skeleton.names), np.append(-1, skeleton.parent + 1).astype(np.int32)), whole


def parent_sizes(character: Character) -> Floats:
    """(J,) how many metres in the stage one unit of each joint's translation is, at rest."""
    world = world_from_local(character.skeleton, character.bind_pose)[..., :3].astype(np.float64)
    size = np.sqrt((world**2).sum(axis=-2)).max(axis=-1)
    parent = character.skeleton.parent
    return np.maximum(np.where(parent < 0, 1.0, size[parent]), 1e-9)


def still_or_keys(draft: Draft, actor: Recorded, node: int, path: Property | Literal["weights"], values: Floats, keys: Keys) -> None:
    """A property (T,n) of a node: written in the node where it never changes, else as a channel."""
    if len(keys.ticks) > 1:
        add_channel(draft, actor, node, path, values, keys)
    elif path == "weights" or not np.array_equal(values[0], DEFAULTS[path]):
        draft.nodes[node][path] = values[0].tolist()


def add_channel(draft: Draft, actor: Recorded, node: int, path: Property | Literal["weights"], values: Floats, keys: Keys) -> None:
    """A channel with the values (T,n) at its keys. Channels with the same keys share their times."""
    times = ((actor.first + keys.ticks) / draft.rate).astype(np.float32)
    times = draft.times.setdefault(times.tobytes(), times)
    chosen = np.ascontiguousarray(values[keys.ticks], np.float32)
    output = draft.builder.array(chosen.reshape(-1, 1) if path == "weights" else chosen)
    draft.samplers.append({"input": draft.builder.array(times, bounds=True), "output": output, "interpolation": keys.interpolation})
    draft.channels.append({"sampler": len(draft.samplers) - 1, "target": {"node": node, "path": path}})


def place_meshes(draft: Draft, actor: Recorded, first: int) -> None:
    """The meshes of an actor on nodes of their own kind, each once, with the weights of their morph targets."""
    character = actor.character
    if id(character) not in draft.shared:
        draft.shared[id(character)] = share(draft, character)
    shared = draft.shared[id(character)]
    skins = [add_skin(draft, skin, matrices, first) for skin, matrices in zip(character.skins, shared.matrices, strict=True)]
    placed: set[tuple[int, MeshKey]] = set()
    for part in character.parts:
        key = (part.mesh, part.skin)
        if (part.node, key) not in placed:
            placed.add((part.node, key))
            node = rigid_node(draft, first + part.joint) if part.skin is None else skinned_node(draft, actor.name, skins[part.skin])
            draft.nodes[node]["mesh"] = shared.meshes[key]
            add_weights(draft, actor, node, part)


def rigid_node(draft: Draft, joint: int) -> int:
    """A node for a rigid mesh: the joint's own, or one below it where that has a mesh already."""
    if "mesh" not in draft.nodes[joint]:
        return joint
    below = new_node(draft, {"name": f"{draft.nodes[joint]['name']} mesh"})
    draft.nodes[joint].setdefault("children", []).append(below)
    return below


def skinned_node(draft: Draft, name: str, skin: int) -> int:
    """A node for a skinned mesh, which no transform but its joints' moves: it belongs to the scene (3.7.3.3)."""
    node = new_node(draft, {"name": f"{name} skin {skin}", "skin": skin})
    draft.roots.append(node)
    return node


def add_weights(draft: Draft, actor: Recorded, node: int, part: Primitive) -> None:
    """The morph weights of a mesh's node."""
    if part.target_positions is not None:
        values = actor.poses.weights[:, part.weight_first : part.weight_first + len(part.target_positions)]
        still_or_keys(draft, actor, node, "weights", values, needed(values[:, None], np.array([SHARE]))[0])


def share(draft: Draft, character: Character) -> Shared:
    """Lay out the meshes, materials and textures of a character."""
    first = len(draft.materials)
    first_texture = add_textures(draft.builder, draft.resources, character)
    draft.materials += [moved(material, first_texture) for material in character.materials]
    meshes: dict[MeshKey, int] = {}
    for key, parts in grouped(character.parts).items():
        meshes[key] = len(draft.meshes)
        draft.meshes.append({"primitives": [mesh_primitive(draft.builder, part, first) for part in parts]})
    return Shared(meshes, [draft.builder.array(matrix_columns(skin)) for skin in character.skins])


def mesh_primitive(builder: Builder, part: Primitive, first_material: int) -> Json:
    """A primitive, its material counted in the recording."""
    entry = primitive_entry(builder, part)
    return {**entry, "material": entry["material"] + first_material} if "material" in entry else entry


def add_skin(draft: Draft, skin: Skin, matrices: int, first: int) -> int:
    """A skin for one actor's joints; its index."""
    draft.skins.append({"name": skin.name, "joints": (first + skin.joints).tolist(), "inverseBindMatrices": matrices})
    return len(draft.skins) - 1
