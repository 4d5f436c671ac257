"""Chooses the keys of a moving skeleton that are needed to keep every joint within half a millimetre of its
position in the stage, at every tick.

An error of a joint moves all joints below it, and errors add up along a chain. So keys are first dropped by
each joint's own bounds; then the skeleton is posed from the kept keys, and the bounds of each joint that is
too far off, and of its ancestors, are tightened.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from statwalk.files.gltf.keys import Keys, every_key, reduce_keys, restored
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.rig.evaluate import world_from_local
from statwalk.rig.skeleton import Skeleton

METRES = 5e-4
"""largest distance of a joint from its position in the stage"""
OWN_METRES, RADIANS, SHARE = 1e-4, 2e-4, 1e-4
"""largest error of a joint's own keys, relative to its parent: in translation, rotation and scale"""
MOST_ROUNDS = 12
TIGHTEST, LOOSEST = 0.2, 0.7
"""factors by which bounds are tightened in a round"""
Property = Literal["translation", "rotation", "scale"]
PROPERTIES: tuple[Property, ...] = ("translation", "rotation", "scale")


class WorldKeys:
    """The kept keys of J joints in poses (T,J,…); the skeleton's roots are in stage space.

    kept     for each property the keys of every joint
    sizes    (J,) the length in metres, in the stage, of one unit of each joint's translation

    `checkpoint` is called during the search; an exception in it ends the search.
    """

    def __init__(
        self, skeleton: Skeleton, poses: Pose, sizes: Floats, checkpoint: Callable[[], None] = lambda: None
    ) -> None:
        self.skeleton, self.checkpoint = skeleton, checkpoint
        self.source = {path: np.asarray(getattr(poses, path), np.float32) for path in PROPERTIES}
        self.restored = {path: values.copy() for path, values in self.source.items()}
        count = len(self.source["scale"])
        self.kept: dict[Property, list[Keys]] = {path: [every_key(count)] * len(sizes) for path in PROPERTIES}
        same = np.ones(len(sizes))
        self.bounds = {"translation": OWN_METRES / sizes, "rotation": RADIANS * same, "scale": SHARE * same}
        self.exact = self.positions(self.source)
        self.choose()

    def choose(self) -> None:
        """Drops the keys that are not needed; if tighter bounds do not help after MOST_ROUNDS rounds, keeps
        all keys of the joints in question.
        """
        changed = np.arange(len(self.bounds["scale"]))
        for _ in range(MOST_ROUNDS):
            self.drop(changed)
            factor = self._tighter()
            changed = np.flatnonzero(factor < 1)
            if not len(changed):
                return
            self.bounds = {path: bounds * factor for path, bounds in self.bounds.items()}
        for path in PROPERTIES:
            for joint in changed.tolist():
                self.kept[path][joint] = every_key(len(self.exact))

    def drop(self, joints: NDArray[np.intp]) -> None:
        """Chooses the keys of some joints by their own bounds."""
        for path in PROPERTIES:
            self.checkpoint()
            turns = path == "rotation"
            keys_of_joints = reduce_keys(self.source[path][:, joints], self.bounds[path][joints], turns=turns)
            for joint, keys in zip(joints.tolist(), keys_of_joints, strict=True):
                self.kept[path][joint] = keys
                self.restored[path][:, joint] = restored(self.source[path][:, joint], keys, turns=turns)

    def _tighter(self) -> Floats:
        """Returns (J,): the factor for each joint's bounds, below 1 for a joint that is too far off and its
        ancestors.
        """
        error = np.sqrt(((self.positions(self.restored) - self.exact) ** 2).sum(axis=-1)).max(axis=0)
        needed_factor = LOOSEST * METRES / np.maximum(error, METRES)
        factor: Floats = np.where(error > METRES, np.clip(needed_factor, TIGHTEST, LOOSEST), 1.0)
        for joint in range(len(factor) - 1, 0, -1):
            parent = self.skeleton.parent[joint]
            if parent >= 0:
                factor[parent] = min(factor[parent], factor[joint])
        return factor

    def positions(self, values: dict[Property, NDArray[np.float32]]) -> Floats:
        """Returns (T,J,3): the positions of the joints in the stage."""
        pose = Pose(
            values["translation"], values["rotation"], values["scale"], np.zeros((len(values["scale"]), 0))
        )
        return world_from_local(self.skeleton, pose)[..., 3]
