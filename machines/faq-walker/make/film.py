"""Film strips: the skinned body drawn from front, side and above with plain NumPy, written as PNG."""

import struct
import zlib
from pathlib import Path

import numpy as np
from curves import Array
from numpy.typing import NDArray

Image = NDArray[np.float64]
Indices = NDArray[np.int64]
LIGHT = np.array([0.35, 0.75, 0.55])
PAPER = np.array([0.93, 0.93, 0.92])


def look(yaw: float, pitch: float) -> Array:
    """View rotation (3, 3): rows are right, up, towards the eye; yaw 0 looks at the character's face."""
    cy, sy, cp, sp = np.cos(yaw), np.sin(yaw), np.cos(pitch), np.sin(pitch)
    return np.array([[cy, 0, -sy], [-sp * sy, cp, -sp * cy], [cp * sy, sp, cp * cy]])


VIEWS = {
    "front": look(0.0, 0.0),
    "side": look(np.pi / 2, 0.0),
    "back": look(np.pi, 0.0),
    "three-quarter": look(0.65, 0.22),
    "above": np.array([[0.0, 0, 1], [1, 0, 0], [0, 1, 0]]),
}


def draw(
    points: Array,
    normals: Array,
    faces: Indices,
    colours: Array,
    view: Array,
    box: tuple[float, ...],
    scale: float,
) -> Image:
    """One picture (H, W, 3) of triangles of one colour each; `box`: left, bottom, width, height (metres);
    `scale`: pixels a metre.
    """
    width, height = int(box[2] * scale), int(box[3] * scale)
    seen = points @ view.T
    xy = np.stack([(seen[:, 0] - box[0]) * scale, height - (seen[:, 1] - box[1]) * scale], axis=-1)
    image = np.broadcast_to(PAPER, (height, width, 3)).copy()
    ground = int(height + box[1] * scale)
    if 0 <= ground < height and view[1, 1] > 0.5:  # not from above
        image[ground:] *= 0.9
    picked, share = _fill(xy[faces], seen[faces, 2], (width, height))
    hit = np.flatnonzero(picked >= 0)
    face, weights = picked[hit], share[hit]
    normal = (normals[faces[face]] * weights[:, :, None]).sum(1) @ view.T
    light = LIGHT / np.linalg.norm(LIGHT)
    shade = 0.50 + 0.42 * np.clip(normal @ light, -0.3, 1) + 0.12 * normal[:, 2]
    image.reshape(-1, 3)[hit] = np.clip(colours[face] * shade[:, None], 0, 1)
    return image


def _fill(corners: Array, near: Array, size: tuple[int, int]) -> tuple[Indices, Array]:
    """Nearest triangle (P,) or -1 at every pixel's centre, and the shares (P, 3) of its corners; offset by
    offset of the boxes.
    """
    width, height = size
    depth, picked, share = (
        np.full(height * width, -np.inf),
        np.full(height * width, -1),
        np.zeros((height * width, 3)),
    )
    low = np.floor(corners.min(1)).astype(int)
    span = (np.ceil(corners.max(1)).astype(int) - low).max(1)
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    area = _cross(b - a, c - a)
    for dx, dy in np.ndindex(span.max() + 1, span.max() + 1):
        some = np.flatnonzero((span >= max(dx, dy)) & (np.abs(area) > 1e-9))
        pixel = low[some] + (dx, dy)
        p = pixel + 0.5
        w0, w1 = _cross(b[some] - p, c[some] - p) / area[some], _cross(c[some] - p, a[some] - p) / area[some]
        weights = np.stack([w0, w1, 1 - w0 - w1], axis=1)
        ok = (weights >= -0.01).all(1) & (pixel >= 0).all(1) & (pixel < (width, height)).all(1)
        z = (near[some] * weights).sum(1)[ok]
        order = np.argsort(z)
        flat, chosen, z, weights = (
            (pixel[ok, 1] * width + pixel[ok, 0])[order],
            some[ok][order],
            z[order],
            weights[ok][order],
        )
        better = z > depth[flat]
        flat = flat[better]
        depth[flat], picked[flat], share[flat] = z[better], chosen[better], weights[better]
    return picked, share


def _cross(u: Array, v: Array) -> Array:
    return np.asarray(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])


def save(path: Path, image: Image) -> None:
    """Write a picture (H, W, 3) of 0…1 as PNG."""
    pixels = np.round(np.clip(image, 0, 1) * 255).astype(np.uint8)
    rows = b"".join(b"\0" + row.tobytes() for row in pixels)
    head = struct.pack(">IIBBBBB", pixels.shape[1], pixels.shape[0], 8, 2, 0, 0, 0)
    chunks = ((b"IHDR", head), (b"IDAT", zlib.compress(rows, 9)), (b"IEND", b""))
    body = b"".join(
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        for kind, data in chunks
    )
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + body)
