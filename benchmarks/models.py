"""Generates a skinned figure of any size: 67 joints, three clips of one second that move all joints, four
influences a vertex.
"""

from __future__ import annotations

import numpy as np
from statwalk.character.character import Character
from statwalk.files.gltf.write import model_glb
from statwalk.maths.pose import Pose, rest
from statwalk.motion.clip import Channel, Clip
from statwalk.rig.skeleton import Skeleton
from statwalk.skin.primitive import Primitive, Skin

JOINTS, KEYS, CLIPS = 67, 31, 3


def figure(vertices: int, targets: int = 0) -> bytes:
    """Returns the GLB of a figure with `vertices` vertices and `targets` morph targets."""
    chance = np.random.default_rng(7)
    parents = np.array([-1, *((row - 1) // 2 if row > 8 else row - 1 for row in range(1, JOINTS))], np.int32)
    skeleton = Skeleton(tuple(f"joint {row}" for row in range(JOINTS)), parents)
    pose = rest(JOINTS, targets)
    pose.translation[1:] = chance.normal(0, 0.2, (JOINTS - 1, 3))
    inverse = np.zeros((JOINTS, 3, 4), np.float32)
    inverse[:] = np.eye(4)[:3]
    part = Primitive(
        joint=0,
        node=JOINTS,
        mesh=0,
        primitive=0,
        positions=chance.normal(0, 1, (vertices, 3)).astype(np.float32),
        normals=unit(chance.normal(0, 1, (vertices, 3))),
        indices=chance.integers(0, vertices, 3 * vertices).astype(np.uint32),
        skin=0,
        joints=chance.integers(0, JOINTS, (vertices, 4)).astype(np.uint16),
        weights=np.full((vertices, 4), 0.25, np.float32),
        target_positions=chance.normal(0, 0.1, (targets, vertices, 3)).astype(np.float32)
        if targets
        else None,
    )
    skin = Skin("skin", np.arange(JOINTS, dtype=np.int32), inverse)
    clips = {f"clip {row}": clip(f"clip {row}", pose, chance) for row in range(CLIPS)}
    return model_glb(
        Character("figure", skeleton, np.arange(JOINTS, dtype=np.int32), pose, clips, (skin,), (part,))
    )


def unit(vectors: np.ndarray) -> np.ndarray:
    """Returns the vectors at unit length, float32."""
    return (vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)).astype(np.float32)


def clip(name: str, pose: Pose, chance: np.random.Generator) -> Clip:
    """Returns a clip with translation, rotation and scale of all joints at the same times, as exporters write
    sampled actions.
    """
    times = np.linspace(0, 1, KEYS).astype(np.float32)
    channels = []
    for joint in range(JOINTS):
        rotations = chance.normal(np.array([0, 0, 0, 1]), 0.1, (KEYS, 4))
        channels += [
            Channel(
                joint,
                "translation",
                times,
                (pose.translation[joint] + chance.normal(0, 0.01, (KEYS, 3))).astype(np.float32),
            ),
            Channel(joint, "rotation", times, unit(rotations)),
            Channel(joint, "scale", times, chance.normal(1, 0.01, (KEYS, 3)).astype(np.float32)),
        ]
    return Clip(name, tuple(channels), 1.0, pose)
