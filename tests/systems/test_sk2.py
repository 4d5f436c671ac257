"""SK2 skeleton evaluation (FAQ Q14): relative and absolute matrix, start- and end-point of every bone,
against a plain loop.
"""

import numpy as np
from scipy.spatial.transform import Rotation
from statwalk.files.faq.skeleton_text import shipped_skeleton
from statwalk.maths import transform

MAMMAL = shipped_skeleton("mammal")
TURNS = Rotation.from_euler("xyz", np.random.default_rng(23).uniform(-1, 1, (20, 3)))
FRAMES = MAMMAL.evaluate(TURNS.as_quat())


def evaluated_by_the_faqs_steps():
    """Steps [1] to [6] of Q14 for each bone: absolute rotations, start- and end-points."""
    turn, start, end = np.empty((20, 3, 3)), np.empty((20, 3)), np.empty((20, 3))
    for bone, parent in enumerate(MAMMAL.skeleton.parent):
        start[bone] = 0 if parent < 0 else end[parent]
        turn[bone] = TURNS[bone].as_matrix() if parent < 0 else turn[parent] @ TURNS[bone].as_matrix()
        end[bone] = start[bone] + turn[bone] @ MAMMAL.direction[bone] * MAMMAL.length[bone]
    return turn, start, end


def test_points_and_absolute_matrices_are_those_of_the_faqs_steps():
    turn, start, end = evaluated_by_the_faqs_steps()
    np.testing.assert_allclose(FRAMES.absolute[..., :3], turn, atol=1e-13)
    np.testing.assert_allclose(FRAMES.start, start, atol=1e-12)
    np.testing.assert_allclose(FRAMES.end, end, atol=1e-12)


def test_a_bone_starts_where_its_parent_ends():
    children = np.flatnonzero(MAMMAL.skeleton.parent >= 0)
    np.testing.assert_allclose(
        FRAMES.start[children], FRAMES.end[MAMMAL.skeleton.parent[children]], atol=1e-13
    )


def test_absolute_is_the_parents_absolute_times_relative():
    children = np.flatnonzero(MAMMAL.skeleton.parent >= 0)
    product = transform.mul(FRAMES.absolute[MAMMAL.skeleton.parent[children]], FRAMES.relative[children])
    np.testing.assert_allclose(FRAMES.absolute[children], product, atol=1e-13)


def test_bones_keep_their_lengths_in_any_pose():
    np.testing.assert_allclose(np.linalg.norm(FRAMES.end - FRAMES.start, axis=1), MAMMAL.length, atol=1e-12)
