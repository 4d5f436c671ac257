"""One file of ground truth (three.js, checked against NumPy in float64) and the character it is about.

Format: the README of the assets.
"""

import json
from functools import cache, cached_property
from pathlib import Path
from typing import NamedTuple

import numpy as np
from paths import GLTF, GROUND_TRUTH, MACHINES
from statwalk.character.character import Character
from statwalk.files.gltf import read_model
from statwalk.maths.pose import Pose

SUFFIX = ".gt.npz"
ALL = sorted(
    str(path.relative_to(GROUND_TRUTH))[: -len(SUFFIX)]
    for path in GROUND_TRUTH.rglob(f"*{SUFFIX}")
    if (GLTF / str(path.relative_to(GROUND_TRUTH))[: -len(SUFFIX)]).is_file()
)

SHIPPED = sorted(str(path.relative_to(MACHINES)) for path in MACHINES.rglob("*.glb"))
MODELS = ALL or SHIPPED
"""for tests that any model will do for: the shared ones, or, in a clone on its own, the project's"""


def place(model: str) -> Path:
    return MACHINES / model if model in SHIPPED else GLTF / model


@cache
def character(model: str) -> Character:
    path = place(model)
    return read_model(path.read_bytes(), path.stem, path.parent)


class Row(NamedTuple):
    """One sample or blend: which row of the truth, and the pose that must be like it."""

    number: int
    pose: Pose


class Truth:
    def __init__(self, model: str) -> None:
        self.model = model
        with np.load(Path(GROUND_TRUTH) / f"{model}{SUFFIX}") as arrays:
            self.arrays = {name: arrays[name] for name in arrays.files}
        self.meta = json.loads(self.arrays["meta"].tobytes())

    @cached_property
    def rows(self) -> list[Row]:
        samples, blends = self.meta["samples"], self.meta["blends"]
        return [Row(k, self.sampled(s)) for k, s in enumerate(samples)] + [
            Row(len(samples) + k, self.blended(b)) for k, b in enumerate(blends)
        ]

    def sampled(self, sample: dict) -> Pose:
        if sample["clip"] < 0:
            return character(self.model).bind_pose
        return self.at(sample["clip"], sample["t"], sample["mode"] == "loop")

    def at(self, clip: int, time: float, loop: bool = False) -> Pose:
        return list(character(self.model).clips.values())[clip].sample(time, loop=loop)

    def blended(self, blend: dict) -> Pose:
        return self.at(blend["a"], blend["ta"]).blend(self.at(blend["b"], blend["tb"]), blend["w"])

    def points(self, row: Row) -> list[tuple[np.ndarray, np.ndarray]]:
        """For each primitive: ours at the points that the truth has, and the truth's."""
        index, start = self.arrays["vert_index"], self.arrays["vert_row"][row.number]
        parts = {(part.node, part.primitive): part for part in character(self.model).vertices(row.pose)}
        out = []
        for primitive in self.meta["prims"]:
            span = slice(primitive["first"], primitive["first"] + primitive["count"])
            ours = parts[primitive["node"], primitive["prim"]].positions
            out.append((ours[index[span]], self.arrays["verts"][start, span]))
        return out

    def morph(self, row: Row) -> np.ndarray:
        """The weights of every primitive's targets, one primitive after the other."""
        parts = {(part.node, part.primitive): part for part in character(self.model).parts}
        listed = [parts[primitive["node"], primitive["prim"]] for primitive in self.meta["prims"]]
        morphing = [part for part in listed if part.target_positions is not None]
        spans = [row.pose.weights[part.weight_first :][: len(part.target_positions)] for part in morphing]
        return np.concatenate([np.zeros(0, np.float32), *spans])

    @cached_property
    def size(self) -> float:
        return self.meta["cross_check"]["model_size"]


def turn_between(ours: np.ndarray, truth: np.ndarray) -> np.ndarray:
    """The angle in radians between unit quaternions, whatever their sign."""
    nearest = np.minimum(np.linalg.norm(ours - truth, axis=-1), np.linalg.norm(ours + truth, axis=-1))
    return 4 * np.arcsin(np.clip(nearest / 2, 0, 1))
