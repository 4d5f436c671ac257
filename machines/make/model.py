"""A character put together part by part, and written as one binary glTF file."""

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from shapes import Array, Mesh
from statwalk.character.character import Character
from statwalk.files.gltf.write import model_glb
from statwalk.maths.pose import rest
from statwalk.motion.clip import Channel, Clip
from statwalk.rig.skeleton import Skeleton
from statwalk.skin.primitive import Primitive, Skin

KEYS_PER_SECOND = 30
Motion = Mapping[tuple[str, str], Callable[[Array], Array]]
"""for a joint and translation, rotation or scale the values (K, n) at times (K,)"""


def linear(colour: str) -> list[float]:
    """Red, green, blue as light, of a `colour` as on a screen, #rrggbb."""
    screen = np.array([int(colour[at : at + 2], 16) for at in (1, 3, 5)]) / 255
    return [float(round(part, 4)) for part in screen**2.2]


def material(name: str, colour: str, rough: float = 0.6, metal: float = 0.0, **more: Any) -> dict[str, Any]:
    """A glTF material; `colour` as on a screen, #rrggbb."""
    return {
        "name": name,
        "pbrMetallicRoughness": {
            "baseColorFactor": [*linear(colour), 1.0],
            "metallicFactor": metal,
            "roughnessFactor": rough,
        },
        **more,
    }


def turn_about(axis: Sequence[float], degrees: Array) -> Array:
    """Quaternions (K, 4) of turns about a unit axis."""
    half = np.radians(np.asarray(degrees, float)) / 2
    return np.concatenate([np.sin(half)[:, None] * np.array(axis, float), np.cos(half)[:, None]], -1)


def _opaque(colours: Array) -> Any:
    return np.concatenate([colours, np.ones((len(colours), 1))], 1).astype(np.float32)


class Model:
    """Joints, parts and clips."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.names: list[str] = []
        self.parents: list[int] = []
        self.places: list[tuple[float, float, float]] = []
        self.sizes: list[float] = []
        self.parts: list[Primitive] = []
        self.skins: list[Skin] = []
        self.materials: list[dict[str, Any]] = []
        self.motions: list[tuple[str, float, Motion, int]] = []

    def joint(
        self, name: str, parent: str = "", at: tuple[float, float, float] = (0.0, 0.0, 0.0), size: float = 1.0
    ) -> str:
        """A new joint, `at` metres from its parent, scaled by `size`; returns its name."""
        self.names.append(name)
        self.parents.append(self.names.index(parent) if parent else -1)
        self.places.append(at)
        self.sizes.append(size)
        return name

    def part(self, joint: str, surface: Mesh, stuff: dict[str, Any]) -> None:
        """A rigid part, in the space of its joint."""
        row = self.names.index(joint)
        before = sum(part.joint == row and part.skin is None for part in self.parts)
        self.parts.append(
            Primitive(joint=row, node=row, mesh=row, primitive=before, **self._surface(surface, stuff))
        )

    def skinned(
        self,
        surface: Mesh,
        stuff: dict[str, Any],
        weights: Mapping[str, Array],
        colours: Array | None = None,
    ) -> None:
        """A part in the character's space that several joints bend, each with weights (V,); `colours` (V, 3)
        of its points, as light.
        """
        rows = np.array([self.names.index(joint) for joint in weights], np.int32)
        inverse = np.tile(np.eye(4, dtype=np.float32)[:3], (len(rows), 1, 1))
        inverse[:, :, 3] = [-self._from_root(row) for row in rows.tolist()]
        number = 100 + len(self.skins)
        self.skins.append(Skin(f"skin {number}", rows, inverse))
        shares = np.stack(list(weights.values()), -1)
        most = int((shares > 0).sum(1).max())
        joints = np.argsort(-shares, axis=1, kind="stable")[:, :most]
        shares = np.take_along_axis(shares, joints, 1)
        self.parts.append(
            Primitive(
                joint=0,
                node=number,
                mesh=number,
                primitive=0,
                skin=len(self.skins) - 1,
                joints=joints.astype(np.uint16),
                weights=(shares / shares.sum(1, keepdims=True)).astype(np.float32),
                attributes={} if colours is None else {"COLOR_0": _opaque(colours)},
                **self._surface(surface, stuff),
            )
        )

    def motion(self, name: str, seconds: float, motion: Motion, rate: int = KEYS_PER_SECOND) -> None:
        """A clip with `rate` keys a second."""
        self.motions.append((name, seconds, motion, rate))

    def write(self, path: Path) -> None:
        """The file."""
        pose = rest(len(self.names))
        pose.translation[:] = self.places
        pose.scale[:] = np.array(self.sizes)[:, None]
        skeleton = Skeleton(tuple(self.names), np.array(self.parents, np.int32))
        clips = {name: self._clip(name, *form, pose) for name, *form in self.motions}
        index = np.arange(len(self.names), dtype=np.int32)
        numbers = {
            part.node: len(self.names) + row
            for row, part in enumerate(part for part in self.parts if part.skin is not None)
        }
        parts = tuple(
            part
            if part.skin is None
            else Primitive(**{**vars(part), "node": numbers[part.node], "mesh": numbers[part.node]})
            for part in self.parts
        )
        character = Character(
            self.name, skeleton, index, pose, clips, tuple(self.skins), parts, tuple(self.materials)
        )
        path.write_bytes(model_glb(character))
        triangles = sum(len(part.indices) // 3 for part in self.parts if part.indices is not None)
        print(
            f"{path.parent.name}/{path.name}: {path.stat().st_size // 1024} KiB, {len(self.names)} joints, "
            f"{triangles} triangles"
        )

    def _surface(self, surface: Mesh, stuff: dict[str, Any]) -> dict[str, Any]:
        if stuff not in self.materials:
            self.materials.append(stuff)
        return {
            "positions": surface.points.astype(np.float32),
            "normals": surface.normals.astype(np.float32),
            "indices": surface.faces.reshape(-1).astype(np.uint32),
            "material": self.materials.index(stuff),
        }

    def _from_root(self, row: int) -> Array:
        place = np.zeros(3)
        while row >= 0:
            place += self.places[row]
            row = self.parents[row]
        return place

    def _clip(self, name: str, seconds: float, motion: Motion, rate: int, pose: Any) -> Clip:
        times = np.linspace(0, seconds, max(2, round(seconds * rate) + 1))
        channels = [
            Channel(
                self.names.index(joint), path, times.astype(np.float32), np.asarray(values(times), np.float32)
            )
            for (joint, path), values in motion.items()
        ]
        return Clip(name, tuple(channels), seconds, pose)
