"""Inverse kinematics of a character's poses from Python and over REST (IK13 to IK15): names and ranges are
checked here, and the code of a tick solves.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from statwalk.character.chain_of_names import chain_joints, ends_at, sensitivities
from statwalk.errors import ContentError, UnknownNameError
from statwalk.maths.arrays import Floats
from statwalk.maths.clamp_kinds import TOLERANCE
from statwalk.maths.clamp_table import JointLimit, clamp_table
from statwalk.maths.pose import Pose
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.rig.skeleton import Skeleton
from statwalk.solve.chains import (
    DEFAULT_ITERATIONS,
    MOST_ITERATIONS,
    NO_POLE,
    POLE_DIRECTION,
    POLE_POINT,
    SOLVERS,
    Chain,
)
from statwalk.solve.solve_poses import Goal, solve_poses

SMALLEST_CUT = 2 * TOLERANCE
"""radians: less is rounding"""
FURTHEST = 1e6
"""metres: largest coordinate of a target"""


@dataclass(frozen=True)
class SolverOptions:
    """The options of a solver, with their defaults.

    solver       two-bone, ccd, fabrik, force or look-at
    softening    metres before full stretch from which the chain eases, 0…1e6; 0 does not ease
    tolerance    metres from the target at which the target counts as reached and iterations stop, above 0
    iterations   at most, 1…10,000; None: two-bone 16, ccd 256, fabrik 512, force 2,000, look-at 8
    sensitivity  by joint, 0 (stays) … 1 (turns as much as the solver wants); 1 for joints that are left out;
                 not for two-bone
    forward      look-at: the line of sight in the frame of the last joint; any length but 0
    limits       by joint, instead of the character's
    anchor       the first joint of the chain, which stays, or the last: then the first comes to the target,
                 and the root of the skeleton moves; empty: the first
    """

    solver: str = "two-bone"
    softening: float = 0.0
    tolerance: float = 1e-4
    iterations: int | None = None
    sensitivity: Mapping[str, float] = field(default_factory=dict)
    forward: tuple[float, float, float] = (0.0, 0.0, 1.0)
    limits: Mapping[str, JointLimit] = field(default_factory=dict)
    anchor: str = ""

    def check(self) -> None:
        """Checks the ranges.

        :raises ContentError: when an option is outside its range; `place` is its name.
        :raises UnknownNameError: when there is no such solver.
        """
        if self.solver not in SOLVERS:
            raise UnknownNameError("solver", str(self.solver), SOLVERS)
        _in_range("softening", self.softening, 0, FURTHEST)
        _in_range("tolerance", self.tolerance, 1e-9, FURTHEST)
        if self.iterations is not None:
            _whole("iterations", self.iterations, 1, MOST_ITERATIONS)
        if not isinstance(self.anchor, str):
            raise ContentError(f"the name of a joint is needed, not {self.anchor!r:.40}", place="anchor")
        _mapping("sensitivity", self.sensitivity, "{joint: 0…1}")
        _mapping("limits", self.limits, "{joint: limit}")
        for name, limit in self.limits.items():
            if not isinstance(limit, JointLimit):
                raise ContentError(f"a JointLimit is needed, not {limit!r:.40}", place=f"limits.{name}")
        if not np.linalg.norm(_numbers("forward", self.forward, 3)) > 0:
            raise ContentError("a direction needs a length above 0", place="forward")


@dataclass(frozen=True, eq=False)
class SolveAnswer:
    """A solved pose; the other members have the pose's leading axis, if it has one."""

    pose: Pose
    reached: NDArray[np.bool_]
    """(…) whether the end is within the tolerance of the target"""
    distance: NDArray[np.float32]
    """(…) metres from the end (from the start, if the end is the anchor) to the target; look-at: from the
    line of sight; 0 where the weight is 0
    """
    iterations: NDArray[np.int64]
    """(…) that were made"""
    clamped: Mapping[str, Floats]
    """radians (…) by which limits cut the last turn of a joint, by its name; other joints are left out"""

    def __repr__(self) -> str:
        reached = f"{np.count_nonzero(self.reached)} of {np.size(self.reached)} reached"
        farthest, most = np.max(self.distance, initial=0), np.max(self.iterations, initial=0)
        return f"SolveAnswer({reached}, at most {farthest:.4g} m away, at most {most} iterations)"


def solve_pose(
    skeleton: Skeleton,
    rest: Pose,
    pose: Pose,
    chain: Sequence[str],
    options: SolverOptions,
    target: ArrayLike,
    weight: ArrayLike = 1.0,
    pole: ArrayLike | None = None,
    pole_point: ArrayLike | None = None,
    rotation: ArrayLike | None = None,
) -> SolveAnswer:
    """Returns the pose, or the poses (N, J, …), in which the chain's end comes to the target.

    :raises ContentError: when a value has the wrong shape or is out of its range.
    :raises UnknownNameError: when there is no such joint or solver.
    """
    options.check()
    _check_names(chain)
    if not isinstance(pose, Pose):
        raise ContentError(f"a pose is needed, not {type(pose).__name__}", place="pose")
    if pole is not None and pole_point is not None:
        raise ContentError("give the pole as a direction or as a point, not both", place="pole")
    lead = pose.rotation.shape[:-2]
    if pose.rotation.shape[-2:] != rest.rotation.shape or len(lead) > 1:
        raise ContentError(f"a pose of {pose.rotation.shape} for {len(skeleton)} joints", place="pose")
    goal = Goal(
        _of_actors("target", target, lead, 3),
        _weight(weight, lead),
        _of_actors("pole", (0, 0, 0) if pole is pole_point is None else _either(pole, pole_point), lead, 3),
        _rotation(rotation, lead),
    )
    kind = NO_POLE if pole is pole_point is None else POLE_POINT if pole is None else POLE_DIRECTION
    made = _chain(skeleton, chain, options, kind, rotation is not None)
    limits = {skeleton.index(name): limit for name, limit in options.limits.items()}
    poses = pose if lead else Pose(*(part[None] for part in pose))
    buffer = PoseBuffer.of(rest, Pose(*(np.asarray(part, np.float32) for part in poses)))
    solved = solve_poses(buffer, skeleton.parent, clamp_table(limits, rest), made, goal)
    reached = (solved.distance <= options.tolerance) & (goal.weight > 0)
    cut = {
        skeleton.names[joint]: solved.cut[:, place] if lead else solved.cut[0, place]
        for place, joint in enumerate(made.joints)
        if solved.cut[:, place].max(initial=0) > SMALLEST_CUT
    }
    if lead:
        return SolveAnswer(buffer.poses(), reached, solved.distance, solved.iterations, cut)
    return SolveAnswer(buffer.poses().take(0), reached[0], solved.distance[0], solved.iterations[0], cut)


def _chain(
    skeleton: Skeleton, names: Sequence[str], options: SolverOptions, pole_kind: int, turns_end: bool
) -> Chain:
    joints, middle = chain_joints(skeleton, names, options.solver)
    direction = np.asarray(options.forward) / np.linalg.norm(options.forward)
    if options.anchor and options.solver == "look-at":
        raise ContentError("look-at has no anchor: its chain turns where it is", place="anchor")
    is_moored = bool(options.anchor) and ends_at(skeleton, joints, options.anchor)
    return Chain(
        solver=options.solver,
        joints=joints,
        sensitivity=sensitivities(skeleton, names, joints, options.solver, options.sensitivity),
        middle=middle,
        softening=options.softening,
        tolerance=options.tolerance,
        iterations=options.iterations or DEFAULT_ITERATIONS[options.solver],
        pole_kind=pole_kind,
        forward=(float(direction[0]), float(direction[1]), float(direction[2])),
        turns_end=turns_end,
        is_moored=is_moored,
    )


def _either(pole: ArrayLike | None, pole_point: ArrayLike | None) -> ArrayLike:
    chosen = pole_point if pole is None else pole
    assert chosen is not None
    return chosen


def _weight(weight: ArrayLike, lead: tuple[int, ...]) -> Floats:
    values = _of_actors("weight", np.asarray(weight)[..., None], lead, 1)[..., 0]
    if values.min(initial=0) < 0 or values.max(initial=0) > 1:
        raise ContentError("a weight is 0…1", place="weight")
    return np.broadcast_to(values, lead or (1,))


def _rotation(rotation: ArrayLike | None, lead: tuple[int, ...]) -> Floats:
    if rotation is None:
        return np.array([0.0, 0.0, 0.0, 1.0])
    values = _of_actors("rotation", rotation, lead, 4)
    lengths = np.linalg.norm(values, axis=-1, keepdims=True)
    if not (lengths > 1e-6).all():
        raise ContentError("a rotation x y z w needs a length above 0", place="rotation")
    unit: Floats = values / lengths
    return unit


def _of_actors(name: str, values: Any, lead: tuple[int, ...], width: int) -> Floats:
    """(width) or (N, width) numbers."""
    numbers = _numbers(name, values, width)
    if numbers.shape[:-1] not in ((), lead):
        raise ContentError(f"{numbers.shape[:-1]} values for poses {lead}", place=name)
    return numbers


def _numbers(name: str, values: Any, width: int) -> Floats:
    try:
        numbers = np.asarray(values, np.float64)
    except (TypeError, ValueError):
        raise ContentError(f"{width} numbers are needed", place=name) from None
    if numbers.ndim == 0 or numbers.shape[-1] != width:
        raise ContentError(f"{width} numbers are needed, not {numbers.shape}", place=name)
    if not (np.abs(numbers) <= FURTHEST).all():
        raise ContentError(f"numbers lie within -{FURTHEST:g}…{FURTHEST:g}", place=name)
    return numbers


def _check_names(chain: Any) -> None:
    if not isinstance(chain, Sequence) or not all(isinstance(name, str) for name in chain):
        wanted = "the name of a chain, or the names of its joints from start to end"
        raise ContentError(f"{wanted}, not {chain!r:.40}", place="chain")


def _mapping(name: str, value: Any, form: str) -> None:
    if not isinstance(value, Mapping):
        raise ContentError(f"{form} is needed, not {type(value).__name__}", place=name)


def _whole(name: str, value: Any, low: int, high: int) -> None:
    if not isinstance(value, int | np.integer):
        raise ContentError(f"a whole number is needed, not {value!r:.40}", place=name)
    _in_range(name, int(value), low, high)


def _in_range(name: str, value: Any, low: float, high: float) -> None:
    if not isinstance(value, int | float | np.integer | np.floating):
        raise ContentError(f"a number is needed, not {value!r:.40}", place=name)
    if not low <= value <= high:
        raise ContentError(f"{value:g} is outside {low:g}…{high:g}", place=name)
