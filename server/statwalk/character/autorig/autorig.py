"""Gives a body a skin: joints, then weights of every vertex (DS4; RTCA 2.3.1)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import chain, count
from typing import NamedTuple

import numpy as np

from statwalk.character.autorig.added_joints import (
    PlacedJoint,
    depth_first,
    placed_lines,
    with_joints,
)
from statwalk.character.autorig.bend_clip import bend_clip
from statwalk.character.autorig.bind_space import BindSpace, RigBody, bind_space, shell_of
from statwalk.character.autorig.bone_lines import bone_lines
from statwalk.character.autorig.human import HUMAN, human_lines
from statwalk.character.autorig.mammal import MAMMAL, mammal_lines
from statwalk.character.autorig.parts import part_joints
from statwalk.character.autorig.skinned import with_skin
from statwalk.character.autorig.template import placed
from statwalk.character.autorig.wish import RigWish
from statwalk.errors import ContentError
from statwalk.maths.arrays import Floats, Ints
from statwalk.skin.binding.bind_surface import bind
from statwalk.skin.binding.body_graph import BodyGraph, body_graph
from statwalk.skin.binding.bone_distance import BoneLines
from statwalk.skin.binding.shell import Shell
from statwalk.skin.binding.volume import volume_of

FEWEST_JOINTS = 2
TEMPLATE_CELLS, PARTS_CELLS = 128, 64
"""voxels along the longest side of the body in which joints are placed: fine ones keep an arm apart from the
hip, coarse ones make no limb of a fold
"""
MOST_GRAPH_VOXELS = 60_000
TURNED = {"+z": (0, 1), "-z": (0, -1), "+x": (-1, 0), "-x": (1, 0)}
"""sine and cosine of the turn about +Y that brings a facing to +Z"""
TEMPLATES = {"human": (HUMAN, human_lines), "mammal": (MAMMAL, mammal_lines)}
Progress = Callable[[str, float], None]
"""gets the name of the work and the share that is done"""


class RigFrame(NamedTuple):
    """The joints (K,) that bend a body, the matrices (K,3,4) at which they are bound, and their bones."""

    joints: Ints
    bound: Floats
    bones: BoneLines


def rigged_body(body: RigBody, wish: RigWish, progress: Progress = lambda _words, _share: None) -> RigBody:
    """Returns the body with a skin on all its parts; a skin that it had is replaced.

    :raises ContentError: when the model has no triangles, is too large, has no joints of its own, or does not
        fit the template.
    """
    progress("reading the mesh", 0.0)
    space = bind_space(body)
    shell = shell_of(body, space.placed)
    own = own_joints(body, space) if wish.skeleton == "own" else None
    progress("filling the body", 0.1)
    volume = volume_of(shell)
    progress("placing joints", 0.3)
    if own is not None:
        bones = bone_lines(body.skeleton, own, space.joints[:, :, 3], volume)
        whole, frame = body, RigFrame(own, space.joints[own], bones)
    else:
        whole, frame = _new_skeleton(body, _new_joints(shell, wish))
    if not len(frame.bones.joint):
        raise ContentError("no bone of the skeleton lies in the mesh; is it of the same size and place?")
    progress("weighing vertices", 0.5)
    weights = bind(
        shell,
        volume,
        frame.bones,
        len(frame.joints),
        wish.weights,
        lambda share: progress("weighing vertices", 0.5 + 0.5 * share),
    )
    skinned = with_skin(whole, space, frame.joints, frame.bound, weights[shell.of_vertex])
    return skinned if own is not None and body.clips else _with_clip(skinned, frame.joints)


def _with_clip(body: RigBody, joints: Ints) -> RigBody:
    """The body with a clip more, which bends each joint."""
    name = next(name for name in _clip_names() if name not in body.clips)
    clip = bend_clip(name, body.skeleton, body.bind_pose, joints)
    return replace(body, clips={**body.clips, name: clip}) if clip.channels else body


def _clip_names() -> Iterator[str]:
    return chain(["Bend"], (f"Bend {number}" for number in count(2)))


def _new_joints(shell: Shell, wish: RigWish) -> list[PlacedJoint]:
    """The joints of a template, or of the mesh alone."""
    sine, cosine = TURNED[wish.facing]
    turn = np.array([[cosine, 0, sine], [0, 1, 0], [-sine, 0, cosine]], np.float64)
    cells = TEMPLATE_CELLS if wish.skeleton in TEMPLATES else PARTS_CELLS
    graph = _graph(shell._replace(points=shell.points @ turn.T), cells)
    if wish.skeleton in TEMPLATES:
        rows, lines_of = TEMPLATES[wish.skeleton]
        joints = placed(rows, lines_of(graph))
    else:
        joints = part_joints(graph)
    turned_back = [
        joint._replace(place=joint.place @ turn, tip=None if joint.tip is None else joint.tip @ turn)
        for joint in joints
    ]
    return depth_first(turned_back)


def _graph(shell: Shell, cells: int) -> BodyGraph:
    """The ways through a body; a bulky body has coarser voxels."""
    volume = volume_of(shell, cells)
    solid = int(np.count_nonzero(volume.solid))
    if solid > MOST_GRAPH_VOXELS:
        volume = volume_of(shell, int(cells * (MOST_GRAPH_VOXELS / solid) ** (1 / 3)))
    return body_graph(volume)


def _new_skeleton(body: RigBody, joints: list[PlacedJoint]) -> tuple[RigBody, RigFrame]:
    whole, rows = with_joints(body, joints)
    bound = np.zeros((len(joints), 3, 4))
    bound[:] = np.eye(3, 4)
    bound[:, :, 3] = [joint.place for joint in joints]
    return whole, RigFrame(rows, bound, placed_lines(joints))


def own_joints(body: RigBody, space: BindSpace) -> Ints:
    """Returns the joints that a file has: of its skins, otherwise the nodes without a mesh. Muscle bones are
    no bones of the body, so that they get no vertices (DS6).

    :raises ContentError: when there is none of the skins, or fewer than two others.
    """
    muscles = [body.skeleton.index(name) for name in body.skeleton.muscle_bones]
    is_body = np.ones(len(body.skeleton), bool)
    is_body[muscles] = False
    fewest = FEWEST_JOINTS
    if space.is_skin_joint.any():
        is_body &= space.is_skin_joint
        fewest = 1
    else:
        is_body[[part.joint for part in body.parts]] = False
    if is_body.sum() < fewest:
        besides = " besides its muscle bones" if muscles else ""
        raise ContentError(
            f"the model has no skeleton of its own{besides}; choose the skeleton human, mammal or parts"
        )
    return np.flatnonzero(is_body)
