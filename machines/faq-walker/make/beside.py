"""A film strip of the walk above one of a captured walk on the same figure, from three sides:
`python machines/faq-walker/make/beside.py walk.bvh strip.png`.

Both begin with the left foot farthest ahead.
"""

import sys
from pathlib import Path

import film
import numpy as np
import statwalk
from curves import Array
from mesh.body import make_body
from skeleton import MORE, NAMES
from statwalk.motion.clip import Clip
from strip import SCALE, skinned, surface_of

PICTURES = 8
VIEWS = {
    "side": (-0.62, -0.06, 1.24, 1.90),
    "front": (-0.62, -0.06, 1.24, 1.90),
    "above": (-0.62, -0.5, 1.24, 1.0),
}
LEFT_FOOT = NAMES.index("Left.foot")
STEPS_APART = 0.7  # seconds between two strides at the least
WALKER = statwalk.load(Path(__file__).resolve().parents[1] / "walker.glb")


def poses(clip: Clip, times: Array) -> Array:
    """World matrices (F, J, 3, 4) of the figure's joints."""
    rows = [list(WALKER.skeleton.names).index(name) for name in (*NAMES, *MORE)]
    return np.asarray(WALKER.world(clip.sample(times)), float)[:, rows, :3]


def stride(clip: Clip) -> Array:
    """Moments of one cycle (seconds) from the left foot farthest ahead."""
    times = np.arange(0.0, clip.duration, 1 / 120)
    matrices = poses(clip, times)
    ahead = matrices[:, LEFT_FOOT, 2, 3] - matrices[:, 0, 2, 3]
    first = times[ahead[times < clip.duration - STEPS_APART].argmax()]
    later = (times > first + STEPS_APART) & (times < first + 2 * STEPS_APART)
    again = times[later][ahead[later].argmax()] if later.sum() > 60 else first + clip.duration
    return first + np.arange(PICTURES) * (again - first) / PICTURES


def row(clip: Clip, view: str) -> film.Image:
    """Pictures side by side, each with the root in the middle."""
    body = make_body()
    faces, colours = surface_of(body)
    pictures = []
    for matrices in poses(clip, np.mod(stride(clip), clip.duration)):
        points, normals = skinned(body, matrices)
        middle = points - matrices[0, :, 3] * (1, 0, 1)
        pictures.append(film.draw(middle, normals, faces, colours, film.VIEWS[view], VIEWS[view], SCALE))
    return np.concatenate(pictures, axis=1)


if __name__ == "__main__":
    capture = statwalk.load(sys.argv[1], position="replace")
    captured, _ = statwalk.retarget(next(iter(capture.clips.values())), capture, WALKER)
    clips = (WALKER.clips["walk"], captured)
    film.save(Path(sys.argv[2]), np.concatenate([row(clip, view) for view in VIEWS for clip in clips]))
