"""The hierarchy joint by joint with NumPy: the independent answer to `statwalk.rig.hierarchy`."""

import numpy as np
from statwalk.maths import transform
from statwalk.maths.pose import Pose


def worlds(parents, pose):
    """The transforms (…, J, 3, 4) of joints below their parents, float64."""
    local = transform.from_trs(*(array.astype(np.float64) for array in pose[:3]))
    out = np.empty_like(local)
    for joint, parent in enumerate(parents):
        own = local[..., joint, :, :]
        out[..., joint, :, :] = own if parent < 0 else transform.mul(out[..., parent, :, :], own)
    return out


def under(roots, parents, pose):
    """The same for actors at `roots` (N, 3, 4)."""
    return transform.mul(roots[:, None], worlds(parents, Pose(*pose)))
