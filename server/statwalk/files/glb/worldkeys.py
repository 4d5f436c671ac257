"""Which keys of a moving skeleton matter: with them alone every joint is within half a millimetre of its place in the stage, at every tick.

An error of one joint moves all that hangs on it, and errors add up along a chain. So keys are dropped by each joint's own bounds first;
then the skeleton is posed from what is left, and the bounds of those joints that lead to one that strayed are drawn tighter.
"""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from statwalk.files.glb.keys import Keys, every_key, needed, restored
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.rig.evaluate import world_from_local
from statwalk.rig.skeleton import Skeleton

METRES = 5e-4
"""how far any joint may be from its place in the stage"""
OWN_METRES, RADIANS, SHARE = 1e-4, 2e-4, 1e-4
"""what a joint's own keys may be off at the most: beside its parent, in its turn, in its scale"""
MOST_ROUNDS = 12
TIGHTEST, LOOSEST = 0.2, 0.7
"""by how much bounds are drawn tighter at a time"""
Property = Literal["translation", "rotation", "scale"]
PROPERTIES: tuple[Property, ...] = ("translation", "rotation", "scale")


class WorldKeys:
    """The keys that are kept of J joints in poses (T,J,…), the roots of which stand in the stage.

    kept     for each property the keys of every joint
    sizes    (J,) how many metres in the stage one unit of each joint's translation is
    """

    def __init__(self, skeleton: Skeleton, poses: Pose, sizes: Floats) -> None:
        self.skeleton = skeleton
        self.given = {path: np.asarray(getattr(poses, path), np.float32) for path in PROPERTIES}
        self.shown = {path: values.copy() for path, values in self.given.items()}
        count = len(self.given["scale"])
        self.kept: dict[Property, list[Keys]] = {path: [every_key(count)] * len(sizes) for path in PROPERTIES}
        same = np.ones(len(sizes))
        self.bounds = {"translation": OWN_METRES / sizes, "rotation": RADIANS * same, "scale": SHARE * same}
        self.exact = self.places(self.given)
        self.choose()

    def choose(self) -> None:
        """Drop what can be dropped; where bounds drawn tight again and again do not help, keep all."""
        changed = np.arange(len(self.bounds["scale"]))
        for _ in range(MOST_ROUNDS):
            self.drop(changed)
            tighter = self.tighter()
            changed = np.flatnonzero(tighter < 1)
            if not len(changed):
                return
            self.bounds = {path: bounds * tighter for path, bounds in self.bounds.items()}
        for path in PROPERTIES:
            for joint in changed.tolist():
                self.kept[path][joint] = every_key(len(self.exact))

    def drop(self, joints: NDArray[np.intp]) -> None:
        """Choose the keys of some joints by their own bounds."""
        for path in PROPERTIES:
            turns = path == "rotation"
            found = needed(self.given[path][:, joints], self.bounds[path][joints], turns=turns)
            for joint, keys in zip(joints.tolist(), found, strict=True):
                self.kept[path][joint] = keys
                self.shown[path][:, joint] = restored(self.given[path][:, joint], keys, turns=turns)

    def tighter(self) -> Floats:
        """(J,) the factor for each joint's bounds: below 1 for those that strayed, and all above them."""
        astray = np.sqrt(((self.places(self.shown) - self.exact) ** 2).sum(axis=-1)).max(axis=0)
        wanted = LOOSEST * METRES / np.maximum(astray, METRES)
        factor: Floats = np.where(astray > METRES, np.clip(wanted, TIGHTEST, LOOSEST), 1.0)
        for joint in range(len(factor) - 1, 0, -1):
            parent = self.skeleton.parent[joint]
            if parent >= 0:
                factor[parent] = min(factor[parent], factor[joint])
        return factor

    def places(self, values: dict[Property, NDArray[np.float32]]) -> Floats:
        """(T,J,3) where the joints are in the stage."""
        pose = Pose(values["translation"], values["rotation"], values["scale"], np.zeros((len(values["scale"]), 0)))
        return world_from_local(self.skeleton, pose)[..., 3]
