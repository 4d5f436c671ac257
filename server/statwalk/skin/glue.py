"""Glue triangles of a skin: triangles whose corners follow different bones, and that stretch between them
(FAQ Q20). DS7.
"""

from __future__ import annotations

import numpy as np

from statwalk.maths.arrays import Ints
from statwalk.skin.primitive import TRIANGLES, Primitive
from statwalk.skin.shading import triangles
from statwalk.skin.skinning import heaviest_bones


def glue_triangles(part: Primitive) -> Ints:
    """Returns the corners (G, 3) of the glue triangles of a part, vertex numbers; none for points, lines, and
    parts without a skin. A vertex follows the heaviest of its bones, as in rigid skinning.
    """
    if part.joints is None or part.weights is None or part.mode < TRIANGLES:
        return np.zeros((0, 3), np.int64)
    every = np.arange(len(part.positions)) if part.indices is None else part.indices
    corners: Ints = triangles(every.astype(np.int64), part.mode)
    bones = heaviest_bones(part.joints, part.weights)[corners]
    glue: Ints = corners[(bones != bones[:, :1]).any(1)]
    return glue
