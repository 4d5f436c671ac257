"""Patches: pieces of surface made of loops of points, put onto a field, stitched and hemmed."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from curves import Array
from mesh.shapes import Field
from mesh.surface import Indices, averaged, edges_of, gradient, project

SAMPLES = 64


@dataclass(frozen=True)
class Patch:
    """Points (V, 3) and triangles (T, 3) by paint, counter-clockwise from outside; `share`: what new joints
    take of the weights (V,) that a place on the body gives.
    """

    points: Array
    faces: Mapping[str, Indices]
    share: Mapping[str, Array] = field(default_factory=dict)

    @property
    def triangles(self) -> Indices:
        """All triangles."""
        return np.concatenate([part.reshape(-1, 3) for part in self.faces.values()])

    def mirrored(self) -> "Patch":
        """The same on the right side."""
        share = {name.replace("Left", "Right"): part for name, part in self.share.items()}
        faces = {paint: part[:, ::-1] for paint, part in self.faces.items()}
        return Patch(self.points * (-1.0, 1.0, 1.0), faces, share)

    def normals(self) -> Array:
        """Unit normals (V, 3): the mean of the faces around, by area."""
        corners = self.points[self.triangles]
        across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        total = np.zeros_like(self.points)
        for corner in range(3):
            np.add.at(total, self.triangles[:, corner], across)
        return np.asarray(total / np.maximum(np.linalg.norm(total, axis=1, keepdims=True), 1e-12))


class Net:
    """A patch in the making: points come in rows, triangles in nets between them."""

    def __init__(self) -> None:
        self.points: list[Array] = []
        self.faces: dict[str, list[Indices]] = {}
        self.share: dict[str, list[tuple[Indices, Array]]] = {}

    def add(self, rows: Array) -> Indices:
        """Take points (…, 3) in; returns their numbers."""
        start = len(self.points)
        self.points.extend(rows.reshape(-1, 3))
        return np.arange(start, len(self.points)).reshape(rows.shape[:-1])

    def cover(self, paint: str, faces: Indices) -> None:
        """Take triangles (T, 3) in."""
        self.faces.setdefault(paint, []).append(faces)

    def give(self, joint: str, rows: Indices, part: Array | float) -> None:
        """Let a new joint have its part of some points."""
        self.share.setdefault(joint, []).append((rows, np.broadcast_to(part, rows.shape)))

    def patch(self) -> Patch:
        """What has come together."""
        shares = {joint: np.zeros(len(self.points)) for joint in self.share}
        for joint, given in self.share.items():
            for rows, part in given:
                shares[joint][rows] = part
        faces = {paint: np.concatenate(some) for paint, some in self.faces.items()}
        return Patch(np.array(self.points), faces, shares)


def both_sides(left: Patch) -> list[Patch]:
    """A patch of the left side, and its mirror image."""
    return [left, left.mirrored()]


def cast(surface: Field, origin: Array, way: Array, far: float = 0.4) -> Array:
    """Points (…, 3) where rays from inside leave the field for the last time within `far` metres."""
    origin, way = np.broadcast_arrays(origin, way / np.linalg.norm(way, axis=-1, keepdims=True))
    reach = np.linspace(0.0, far, SAMPLES)
    inside = surface(origin[..., None, :] + reach[:, None] * way[..., None, :]) < 0
    last = SAMPLES - 1 - np.argmax(inside[..., ::-1], axis=-1)
    low, high = reach[last], reach[np.minimum(last + 1, SAMPLES - 1)]
    for _ in range(24):
        middle = (low + high) / 2
        within = surface(origin + middle[..., None] * way) < 0
        low, high = np.where(within, middle, low), np.where(within, high, middle)
    return np.asarray(origin + low[..., None] * way)


def net(index: Indices, closed: bool = False) -> Indices:
    """Triangles between rows of a table of points (R, C), up and to the right seen from outside; `closed`:
    the last column meets the first.
    """
    if closed:
        index = np.concatenate([index, index[:, :1]], axis=1)
    a, b, c, d = (
        part.reshape(-1) for part in (index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1])
    )
    return np.stack([a, b, c, a, c, d], axis=1).reshape(-1, 3)


def fan(ring: Sequence[int] | Indices, tip: int) -> Indices:
    """Triangles from a closed ring to one point."""
    around = np.asarray(ring)
    return np.stack([around, np.roll(around, -1), np.full(len(around), tip)], axis=1)


def outward(points: Array, faces: Indices, surface: Field) -> Indices:
    """The triangles, turned round if most look into the field."""
    corners = points[faces]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    looks = (across * gradient(surface, corners.mean(1))).sum()
    return faces if looks > 0 else faces[:, ::-1]


def eased_onto(
    surface: Field, points: Array, faces: Indices, fixed: Sequence[int] | Indices, rounds: int
) -> Array:
    """Spreads points evenly over a field; the points of the rows `fixed` stay where they are."""
    edges = edges_of(faces)
    for _ in range(rounds):
        moved = project(surface, points + 0.5 * (averaged(points, edges) - points), 1)
        moved[fixed] = points[fixed]
        points = moved
    final = project(surface, points, 3)
    final[fixed] = points[fixed]
    return final


def rim_edges(faces: Indices) -> Indices:
    """The edges (E, 2) that belong to one triangle only, in its direction."""
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    _, first, count = np.unique(np.sort(edges, axis=1), axis=0, return_index=True, return_counts=True)
    return edges[first[count == 1]]


def hemmed(patch: Patch, rows: Sequence[int] | Indices, thick: float, depth: float, paint: str) -> Patch:
    """The patch with an edge as thick as cloth along the boundary points `rows`, and a lining `depth` metres
    up inside it.
    """
    faces = patch.triangles
    chosen = np.zeros(len(patch.points), bool)
    chosen[rows] = True
    edges = rim_edges(faces)
    edges = edges[chosen[edges].all(1)]
    used = np.unique(edges)
    inner = patch.points - thick * patch.normals()
    back = np.zeros_like(inner)
    links = edges_of(faces)
    for a, b in (links.T, links.T[::-1]):
        keep = chosen[a] & ~chosen[b]
        np.add.at(back, a[keep], patch.points[b[keep]] - patch.points[a[keep]])
    back /= np.maximum(np.linalg.norm(back, axis=1, keepdims=True), 1e-12)
    start = len(patch.points)
    place = np.full(start, -1)
    place[used] = np.arange(len(used))
    first, second = start + place[edges], start + len(used) + place[edges]
    quads = [
        (edges[:, 1], edges[:, 0], first[:, 0], first[:, 1]),
        (first[:, 1], first[:, 0], second[:, 0], second[:, 1]),
    ]
    new = np.concatenate(
        [np.stack([q[0], q[1], q[2], q[0], q[2], q[3]], axis=1).reshape(-1, 3) for q in quads]
    )
    points = np.concatenate([patch.points, inner[used], inner[used] + depth * back[used]])
    grown = {name: np.concatenate([part, part[used], part[used]]) for name, part in patch.share.items()}
    painted = {**patch.faces, paint: np.concatenate([patch.faces.get(paint, np.zeros((0, 3), int)), new])}
    return replace(patch, points=points, faces=painted, share=grown)
