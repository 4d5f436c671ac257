"""A character: skeleton, clips and skins, checked against each other once when the file is read, then
immutable.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from statwalk.character.autorig.autorig import Progress, rigged_body
from statwalk.character.autorig.bind_space import RigBody
from statwalk.character.autorig.wish import Facing, RigWish, SkeletonKind
from statwalk.character.solve_pose import SolveAnswer, SolverOptions, solve_pose
from statwalk.errors import existing
from statwalk.maths import transform
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.clamp_table import JointLimit
from statwalk.maths.columns import lock_fields
from statwalk.maths.formula.assignments import Assignment
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Clip
from statwalk.rig.evaluate import world_from_local
from statwalk.rig.skeleton import Skeleton
from statwalk.skin.binding.bind_surface import Weighting
from statwalk.skin.bulge import Bulge
from statwalk.skin.collapses import DetailLevel
from statwalk.skin.crowd import CrowdSkin, CrowdVertices
from statwalk.skin.deform import Surface, surface
from statwalk.skin.detail.choose_level import coarser_parts
from statwalk.skin.face_muscles import Muscle, contracted, contractions_of
from statwalk.skin.glue import glue_triangles
from statwalk.skin.primitive import Part, Primitive, Skin
from statwalk.skin.rows import finite
from statwalk.skin.skinning import Skinning, reskinned, skinning_of


@dataclass(frozen=True, eq=False)
class Character:
    """The parts of a character; poses are local transforms of its joints, metres and radians.

    skeleton     every node of the file is a joint, parents first
    node_index   (J,) the node in the file (and in model_glb) of each joint
    bind_pose    the pose at rest, unbatched, float32
    clips        by name, in the order of the file; unnamed and repeated names are made unique
    materials    glTF material objects, in the order of the parts' indices
    limits       the limits of joints, by name (SK5, SK6)
    expressions  what moves with what, whichever machine plays it, sorted by dependency (EX1)
    chains       the inverse kinematics chains that the file names: joints from start to end (IK14)
    notes        the repairs made when the file was read
    model_glb    the model as a .glb for any viewer
    target_names (W,) the names of the morph targets, in the order of a pose's weights; or () for none
    muscles      the muscles of its face, whose morph targets have their names (DS9)
    faces        named expressions of the face: the contraction of each muscle
    bulges       muscles that bulge with a joint, as authored (DS8); each has a morph target and an expression
    made         the names of clips that a machine file made of the model's own clips
    levels       of detail, finest first, of parts that have collapses (DS10); empty without an order
    skinning     the way of skinning of `vertices` and of the frames of a stage: one of `SKINNINGS`
    """

    name: str
    skeleton: Skeleton
    node_index: NDArray[np.int32]
    bind_pose: Pose
    clips: Mapping[str, Clip] = field(default_factory=dict)
    skins: tuple[Skin, ...] = ()
    parts: tuple[Primitive, ...] = ()
    materials: tuple[Mapping[str, Any], ...] = ()
    limits: Mapping[str, JointLimit] = field(default_factory=dict)
    expressions: tuple[Assignment, ...] = ()
    chains: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    model_glb: bytes = b""
    made: frozenset[str] = frozenset()
    levels: tuple[DetailLevel, ...] = ()
    target_names: tuple[str, ...] = ()
    muscles: Mapping[str, Muscle] = field(default_factory=dict)
    faces: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    bulges: Mapping[str, Bulge] = field(default_factory=dict)
    skinning: Skinning = "linear"

    def __post_init__(self) -> None:
        lock_fields(self)

    def __repr__(self) -> str:
        vertices = sum(len(part.positions) for part in self.parts)
        size = f"{len(self.skeleton)} joints, {len(self.clips)} clips, {vertices} vertices"
        return f"Character({self.name!r}, {size})"

    def clip(self, name: str) -> Clip:
        """Returns a clip by its name.

        :raises UnknownNameError: when the character has no clip of that name; the error lists the clips.
        """
        return existing("clip", name, self.clips)

    @cached_property
    def targets(self) -> Mapping[str, tuple[int, ...]]:
        """Returns the columns of a pose's weights by the names of the morph targets; a target without a name
        is `target_0`, by its column.
        """
        columns: dict[str, tuple[int, ...]] = {}
        for column, given in enumerate(self.target_names or [""] * self.bind_pose.weights.shape[-1]):
            name = given or f"target_{column}"
            columns[name] = (*columns.get(name, ()), column)
        return columns

    def target(self, name: str) -> tuple[int, ...]:
        """Returns the columns of a pose's weights of the morph targets of a name.

        :raises UnknownNameError: when no morph target has the name; the error lists the names.
        """
        return existing("morph target", name, self.targets)

    def world(self, pose: Pose) -> NDArray[np.floating[Any]]:
        """Returns the matrices (…,J,4,4) of the joints in the character's space, for a pose with any leading
        axes; finite for every pose.
        """
        with np.errstate(over="ignore", invalid="ignore"):
            return finite(transform.to_matrix4(world_from_local(self.skeleton, pose)))

    def solve(
        self,
        pose: Pose,
        chain: str | Sequence[str],
        target: ArrayLike,
        solver: str = "two-bone",
        *,
        weight: ArrayLike = 1.0,
        pole: ArrayLike | None = None,
        pole_point: ArrayLike | None = None,
        rotation: ArrayLike | None = None,
        **options: Any,
    ) -> SolveAnswer:
        """Returns a pose (J, …), or poses (N, J, …), whose chain of named joints, or chain of a name in
        `chains`, comes to the target: inverse kinematics.

        All is in model space: `target` (…, 3) and `pole_point` (…, 3) metres, the direction `pole` (…, 3) in
        which the middle joint bends (two-bone), the end's `rotation` (…, 4). `weight` (…) 0 keeps the pose, 1
        is the solution. `options` are those of `SolverOptions`; `limits` are the character's unless given.

        :raises ContentError: when a value has the wrong shape or is out of its range.
        :raises UnknownNameError: when there is no such joint, chain or solver.
        :raises TypeError: when there is no such option.
        """
        goal = weight, pole, pole_point, rotation
        made = SolverOptions(solver, **{"limits": self.limits} | options)
        names = existing("chain", chain, self.chains) if isinstance(chain, str) else chain
        return solve_pose(self.skeleton, self.bind_pose, pose, names, made, target, *goal)

    def autorig(
        self,
        skeleton: SkeletonKind = "parts",
        weights: Weighting = "heat",
        facing: Facing = "+z",
        progress: Progress = lambda _work, _share: None,
    ) -> Character:
        """Returns the character with a skin that statwalk makes (DS4); a new skeleton gets a clip that
        bends each joint.

        `skeleton`: "own", the joints that the file has; "human" or "mammal", a template placed in the mesh;
        "parts", made of the mesh alone. `weights`: "heat", smooth; "nearest", each vertex follows one bone.
        `facing`: where the mesh looks, for templates. `progress` gets the name of the work and the share that
        is done. `model_glb` stays as it was: `statwalk.rigged` returns the character with its model.

        :raises ContentError: when the model cannot be rigged.
        """
        body = RigBody(self.skeleton, self.node_index, self.bind_pose, self.skins, self.parts, self.clips)
        wish = RigWish(skeleton, weights, facing)
        return replace(self, **rigged_body(body, wish, progress).character_fields())

    def lod(
        self, error: float | None = None, *, vertices: int | None = None, share: float | None = None
    ) -> Character:
        """Returns the character with some of its own vertices (DS10): at most `error` metres from the full
        skin in the poses that were measured, or at most so many `vertices`, or a `share` of them.

        :raises ContentError: without `levels` (`statwalk.with_detail` finds them), or for another wish.
        """
        return replace(self, parts=coarser_parts(self.parts, self.levels, error, vertices, share), levels=())

    def vertices(self, pose: Pose, skinning: str = "") -> list[Part]:
        """Returns every drawable primitive in an unbatched pose: positions and unit normals (V,3) in the
        character's space (RTCA 2.3.2).

        `skinning`: "linear", "dual-quaternion", "rigid" or "parts"; without it the character's own. For
        "parts" they belong to `skinned("parts").shown_parts`: every piece has vertices of its own.

        :raises UnknownNameError: when there is no such way of skinning.
        """
        shown = self.skinned(skinning) if skinning else self
        with np.errstate(over="ignore", invalid="ignore"):
            world = world_from_local(self.skeleton, pose)
            return shown.surface.posed_parts(world, self._contracted(pose.weights))

    def crowd_vertices(self, poses: Pose, skinning: str = "") -> CrowdVertices:
        """Returns the vertices of the character in N poses (N,J,…): sixteen poses side by side, several times
        as fast as pose by pose; `parts(n)` are the parts in pose n, as `vertices` gives them.

        :raises UnknownNameError: when there is no such way of skinning.
        """
        skin = (self.skinned(skinning) if skinning else self)._crowd_skin
        with np.errstate(over="ignore", invalid="ignore"):
            return skin.posed(world_from_local(self.skeleton, poses), self._contracted(poses.weights))

    @cached_property
    def _crowd_skin(self) -> CrowdSkin:
        return CrowdSkin(self.surface)

    def _contracted(self, weights: Floats) -> Floats:
        """The weights of a pose of a clip as a tick would give them: squares and cubes follow."""
        return contracted(weights, contractions_of(self.muscles, self.targets))

    def skinned(self, skinning: str) -> Character:
        """Returns the character with a way of skinning of its own, made on first use: `shown_parts` have the
        weights, and for "parts" the vertices and triangles, of that way.

        :raises UnknownNameError: when there is no such way of skinning.
        """
        way = skinning_of(skinning)
        if way == self.skinning:
            return self
        if way not in self._skinned:
            self._skinned[way] = replace(self, skinning=way)
        return self._skinned[way]

    @cached_property
    def _skinned(self) -> dict[Skinning, Character]:
        return {}

    @cached_property
    def shown_parts(self) -> tuple[Primitive, ...]:
        """Returns the parts as the way of skinning draws them, made on first use."""
        return reskinned(self.parts, self.skinning)

    @cached_property
    def glue_triangles(self) -> tuple[Ints, ...]:
        """Returns for each shown part the corners (G, 3), vertex numbers, of its glue triangles (FAQ Q20)."""
        return tuple(glue_triangles(part) for part in self.shown_parts)

    @cached_property
    def surface(self) -> Surface:
        """Returns the shown parts prepared for the kernels, made on first use."""
        return surface(self.shown_parts, self.skins, is_dual=self.skinning == "dual-quaternion")
