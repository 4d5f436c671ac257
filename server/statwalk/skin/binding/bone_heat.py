"""Smooth weights by bone heat (Baran and Popović 2007, "Automatic Rigging and Animation of 3D Characters",
4): each bone is warm in turn and all others are cold; the weight of a vertex is its temperature at rest.

    −Δw + H·w = H·p

p is 1 where the bone is the nearest that the vertex sees, H is 1/d² for its distance d, and Δ is the
Laplacian of the surface (cotangents). The surface is held together by edges of positive weight, so that
weights lie between 0 and 1, and sum to 1. SciPy is imported on first use.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from statwalk.maths.arrays import Floats, Ints
from statwalk.skin.binding.bone_distance import Sight
from statwalk.skin.binding.shell import Shell

HEAT = 1.0
"""c of the paper: a bone of distance d warms with c/d²"""
SMALLEST_EDGE, LARGEST_EDGE = 1e-3, 1e3
"""bounds of an edge's weight, which is 1/√3 between triangles with equal sides"""
NEAREST = 1e-3
"""share of the diagonal: no bone counts as nearer"""
COLUMNS = 8
"""joints solved at once"""


def heat_weights(
    shell: Shell, seen: Sight, joint: Ints, joints: int, progress: Callable[[float], None] = lambda _: None
) -> Floats:
    """Returns weights (N,joints) of the points of a shell; `joint` (B,) is the joint of each bone.

    A piece of the surface that sees no bone takes its heat from the nearest ones. `progress` is called with
    the share that is done.
    """
    from scipy.sparse.linalg import splu

    warmth, warm = _sources(shell, seen)
    matrix = laplacian(shell) + _diagonal(warmth)
    solver = splu(
        matrix.tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True}
    )
    shares = np.zeros((len(shell.points), joints))
    for bone in range(len(joint)):
        shares[:, joint[bone]] += warm[:, bone]
    used = np.flatnonzero(shares.any(0))
    weights = np.zeros_like(shares)
    for first in range(0, len(used), COLUMNS):
        columns = used[first : first + COLUMNS]
        weights[:, columns] = solver.solve(shares[:, columns])
        progress(min(1.0, (first + COLUMNS) / len(used)))
    return np.clip(weights, 0, 1)


def _sources(shell: Shell, seen: Sight) -> tuple[Floats, Floats]:
    """The warmth M·H of each point (N,), and what each bone gives of it (N,B)."""
    from scipy.sparse.csgraph import connected_components

    mass = np.bincount(shell.triangles.reshape(-1), np.repeat(shell.areas() / 3, 3), len(shell.points))
    mass = np.maximum(mass, 1e-9 * max(float(mass.max(initial=0)), 1e-300))
    chosen = seen.chosen.copy()
    _, piece = connected_components(_edges(shell), directed=False)
    is_blind = ~np.bincount(piece, chosen.any(1)).astype(bool)[piece]
    chosen[is_blind, seen.nearest[is_blind]] = True
    nearest = np.maximum(np.where(chosen, seen.distance, np.inf).min(1), NEAREST * shell.size)
    given = HEAT * chosen * (mass / nearest**2)[:, None]
    return given.sum(1), given


def laplacian(shell: Shell) -> Any:
    """Returns the sparse Laplacian (N,N) of the surface: the cotangents of the angles opposite each edge."""
    weights = _edges(shell)
    return _diagonal(np.asarray(weights.sum(1)).reshape(-1)) - weights


def _edges(shell: Shell) -> Any:
    """The symmetric matrix (N,N) of the weights of edges."""
    from scipy.sparse import coo_matrix

    corners, twice = shell.points[shell.triangles], 2 * shell.areas()
    count, rows, columns, values = len(shell.points), [], [], []
    for corner in range(3):
        here, ahead, behind = (corners[:, (corner + step) % 3] for step in range(3))
        cosine = ((ahead - here) * (behind - here)).sum(1)
        values.append(cosine / np.maximum(twice, 1e-12 * np.abs(cosine) + 1e-300) / 2)
        rows.append(shell.triangles[:, (corner + 1) % 3])
        columns.append(shell.triangles[:, (corner + 2) % 3])
    row, column, value = (np.concatenate(parts) for parts in (rows, columns, values))
    matrix = coo_matrix((value, (row, column)), (count, count)).tocsr()
    matrix = matrix + matrix.T
    matrix.data = np.clip(matrix.data, SMALLEST_EDGE, LARGEST_EDGE)
    return matrix


def _diagonal(values: Floats) -> Any:
    from scipy.sparse import diags

    return diags(values)
