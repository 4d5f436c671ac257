"""A recording while it is built: its nodes, and the channels that move them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.character.character import Character
from statwalk.files.gltf.builder import Builder
from statwalk.files.gltf.check import Json
from statwalk.files.gltf.keys import Keys
from statwalk.files.gltf.textures import Resources, no_resources
from statwalk.files.gltf.world_keys import Property
from statwalk.files.gltf.write import MeshKey
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose

DEFAULTS = {"translation": (0, 0, 0), "rotation": (0, 0, 0, 1), "scale": (1, 1, 1)}


class Recorded(NamedTuple):
    """An actor over T ticks: local poses (T,J,…), positions (T,3) in metres, headings (T,) in radians about
    +Y; `first` is its first tick.
    """

    name: str
    character: Character
    poses: Pose
    root_position: Floats
    heading: Floats
    first: int = 0


class Shared(NamedTuple):
    """Data that all actors of one character share: indices of its meshes, and of its skins' inverse bind
    matrices.
    """

    meshes: dict[MeshKey, int]
    matrices: list[int]


@dataclass
class RecordingDraft:
    """A recording while it is built."""

    rate: float
    checkpoint: Callable[[], None]
    builder: Builder = field(default_factory=Builder)
    nodes: list[Json] = field(default_factory=list)
    roots: list[int] = field(default_factory=list)
    meshes: list[Json] = field(default_factory=list)
    materials: list[Json] = field(default_factory=list)
    skins: list[Json] = field(default_factory=list)
    cameras: list[Json] = field(default_factory=list)
    samplers: list[Json] = field(default_factory=list)
    channels: list[Json] = field(default_factory=list)
    resources: Resources = field(default_factory=no_resources)
    shared: dict[int, Shared] = field(default_factory=dict)
    times: dict[bytes, NDArray[np.float32]] = field(default_factory=dict)


def new_node(draft: RecordingDraft, node: Json) -> int:
    """Adds a node; returns its index."""
    draft.nodes.append(node)
    return len(draft.nodes) - 1


def add_property(
    draft: RecordingDraft,
    actor: Recorded,
    node: int,
    path: Property | Literal["weights"],
    values: Floats,
    keys: Keys,
) -> None:
    """Adds a property (T,n) of a node: in the node itself if it never changes, otherwise as a channel."""
    if len(keys.ticks) > 1:
        add_channel(draft, actor, node, path, values, keys)
    elif path == "weights" or not np.array_equal(values[0], DEFAULTS[path]):
        draft.nodes[node][path] = values[0].tolist()


def add_channel(
    draft: RecordingDraft,
    actor: Recorded,
    node: int,
    path: Property | Literal["weights"],
    values: Floats,
    keys: Keys,
) -> None:
    """Adds a channel with the values (T,n) at its keys. Channels with the same keys share their times."""
    times = ((actor.first + keys.ticks) / draft.rate).astype(np.float32)
    times = draft.times.setdefault(times.tobytes(), times)
    key_values = np.ascontiguousarray(values[keys.ticks], np.float32)
    output = draft.builder.array(key_values.reshape(-1, 1) if path == "weights" else key_values)
    draft.samplers.append(
        {
            "input": draft.builder.array(times, bounds=True),
            "output": output,
            "interpolation": keys.interpolation,
        }
    )
    draft.channels.append({"sampler": len(draft.samplers) - 1, "target": {"node": node, "path": path}})
