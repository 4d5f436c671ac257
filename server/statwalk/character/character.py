"""A character: skeleton, clips and skins, checked against each other once when the file is read, then
immutable.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from statwalk.character.solve_pose import SolveAnswer, SolverOptions, solve_pose
from statwalk.errors import UnknownNameError
from statwalk.maths import transform
from statwalk.maths.clamp_table import JointLimit
from statwalk.maths.columns import lock_fields
from statwalk.maths.formula.assignments import Assignment
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Clip
from statwalk.rig.evaluate import world_from_local
from statwalk.rig.skeleton import Skeleton
from statwalk.skin.deform import Surface, surface
from statwalk.skin.primitive import Part, Primitive, Skin
from statwalk.skin.rows import finite


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
    notes        the repairs made when the file was read
    model_glb    the model as a .glb for any viewer
    made         the names of clips that a machine file made of the model's own clips
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
    notes: tuple[str, ...] = ()
    model_glb: bytes = b""
    made: frozenset[str] = frozenset()

    def __post_init__(self) -> None:
        lock_fields(self)

    def clip(self, name: str) -> Clip:
        """Returns a clip by its name.

        :raises UnknownNameError: when the character has no clip of that name; the error lists the clips.
        """
        if name not in self.clips:
            raise UnknownNameError("clip", name, self.clips)
        return self.clips[name]

    def world(self, pose: Pose) -> NDArray[np.floating[Any]]:
        """Returns the matrices (…,J,4,4) of the joints in the character's space, for a pose with any leading
        axes; finite for every pose.
        """
        with np.errstate(over="ignore", invalid="ignore"):
            return finite(transform.to_matrix4(world_from_local(self.skeleton, pose)))

    def solve(
        self,
        pose: Pose,
        chain: Sequence[str],
        target: ArrayLike,
        solver: str = "two-bone",
        *,
        weight: ArrayLike = 1.0,
        pole: ArrayLike | None = None,
        pole_point: ArrayLike | None = None,
        rotation: ArrayLike | None = None,
        **options: Any,
    ) -> SolveAnswer:
        """Returns a pose (J, …), or poses (N, J, …), whose chain of named joints comes to the target: inverse
        kinematics.

        All is in model space: `target` (…, 3) and `pole_point` (…, 3) metres, the direction `pole` (…, 3) in
        which the middle joint bends (two-bone), the end's `rotation` (…, 4). `weight` (…) 0 keeps the pose, 1
        is the solution. `options` are those of `SolverOptions`; `limits` are the character's unless given.

        :raises ContentError: when a value has the wrong shape or is out of its range.
        :raises UnknownNameError: when there is no such joint or solver.
        :raises TypeError: when there is no such option.
        """
        goal = weight, pole, pole_point, rotation
        made = SolverOptions(solver, **{"limits": self.limits} | options)
        return solve_pose(self.skeleton, self.bind_pose, pose, chain, made, target, *goal)

    def vertices(self, pose: Pose) -> list[Part]:
        """Returns every drawable primitive in an unbatched pose: positions and unit normals (V,3) in the
        character's space (RTCA 2.3.2).
        """
        with np.errstate(over="ignore", invalid="ignore"):
            return self.surface.posed_parts(world_from_local(self.skeleton, pose), pose.weights)

    @cached_property
    def surface(self) -> Surface:
        """Returns the parts prepared for the kernels, made on first use."""
        return surface(self.parts, self.skins)
