"""Quaternions of sixteen at a time against SciPy."""

import numpy as np
import pytest
from late_kernel import late_kernel
from scipy.spatial.transform import Rotation, Slerp
from statwalk.maths.compiling import FLOAT, read, write
from statwalk.maths.simd.lane_quat import from_rotation_vector, mul, normalized, slerp, to_rotation_vector
from statwalk.maths.simd.lanes import load
from statwalk.maths.simd.pose_lanes import load3, load4, store3, store4

RNG = np.random.default_rng(8)
FIRST, SECOND = (Rotation.random(64, random_state=RNG) for _ in range(2))


@late_kernel(read(FLOAT, 3), read(FLOAT, 3), read(FLOAT, 2), write(FLOAT, 3))
def products(a, b, f, out):
    """out (3, B·4, 16): a b, slerp, normalised a + 0 b."""
    size = a.size
    for block in range(a.shape[0]):
        at = 64 * block
        p, q = load4(a, at), load4(b, at)
        store4(out, at, mul(p, q))
        store4(out, at + size, slerp(p, q, load(f, 16 * block)))
        store4(out, at + 2 * size, normalized((p[0] * p[3], p[1] * p[3], p[2] * p[3], p[3] * p[3])))


@late_kernel(read(FLOAT, 3), write(FLOAT, 3), write(FLOAT, 3))
def exponentials(vectors, out, back):
    for block in range(vectors.shape[0]):
        q = from_rotation_vector(load3(vectors, 48 * block))
        store4(out, 64 * block, q)
        store3(back, 48 * block, to_rotation_vector(q))


def lanes(rows):
    """(B, n, 16) of rows (16 B, n)."""
    return np.ascontiguousarray(rows.reshape(-1, 16, rows.shape[1]).swapaxes(1, 2), np.float32)


def unlaned(blocks):
    return blocks.swapaxes(1, 2).reshape(-1, blocks.shape[1])


def angles_between(rows, rotations):
    return (Rotation.from_quat(rows) * rotations.inv()).magnitude()


def worked_out(first, second, fractions):
    out = np.zeros((3, len(first) // 16, 4, 16), np.float32)
    products(
        lanes(first.as_quat()),
        lanes(second.as_quat()),
        fractions.astype(np.float32).reshape(-1, 16),
        out.reshape(3, -1, 16),
    )
    return [unlaned(part) for part in out]


def exponential(vectors):
    blocks = lanes(vectors)
    out, back = np.zeros((len(blocks), 4, 16), np.float32), np.zeros_like(blocks)
    exponentials(blocks, out, back)
    return unlaned(out), unlaned(back)


def test_a_product_is_one_turn_after_the_other():
    assert angles_between(worked_out(FIRST, SECOND, np.zeros(64))[0], FIRST * SECOND).max() < 1e-6


def test_slerp_goes_along_the_shorter_arc_evenly():
    parts = RNG.uniform(size=64)
    found = worked_out(FIRST, SECOND, parts)[1]
    arcs = [
        Slerp([0, 1], Rotation.concatenate(pair))(part)
        for *pair, part in zip(FIRST, SECOND, parts, strict=True)
    ]
    assert angles_between(found, Rotation.concatenate(arcs)).max() < 2e-6
    assert np.linalg.norm(found, axis=1) == pytest.approx(1, abs=1e-6)


def test_between_neighbours_slerp_neither_divides_by_nothing_nor_jumps():
    found = worked_out(FIRST, FIRST * Rotation.from_rotvec([1e-5, 0, 0]), np.full(64, 0.5))[1]
    assert angles_between(found, FIRST).max() < 1e-5
    assert np.isfinite(worked_out(FIRST, FIRST, np.full(64, 0.5))[1]).all()


def test_normalised_is_of_unit_length_and_turns_alike():
    found = worked_out(FIRST, SECOND, np.zeros(64))[2]
    assert np.linalg.norm(found, axis=1) == pytest.approx(1, abs=2e-7)
    assert angles_between(found, FIRST).max() < 1e-6


def test_nothing_normalised_is_the_identity():
    out = np.zeros((3, 4, 16), np.float32)
    products(out[:1].copy(), out[:1].copy(), out[0, :1].copy(), out.reshape(3, 4, 16))
    assert out[2, :, 5].tolist() == [0, 0, 0, 1]


@pytest.mark.parametrize("longest", [1e-6, 0.1, 3.1, 6.28, 12])
def test_a_rotation_vector_turns_as_scipy_says(longest):
    vectors = FIRST.apply([0, 0, 1]) * RNG.uniform(0, longest, (64, 1))
    assert angles_between(exponential(vectors)[0], Rotation.from_rotvec(vectors)).max() < 2e-6


def test_a_neighbour_that_turns_more_than_once_changes_no_bit():
    vectors = FIRST.as_rotvec()
    wild = vectors.copy()
    wild[[5, 40]] *= 9
    here, there = exponential(vectors)[0], exponential(wild)[0]
    assert np.flatnonzero((here != there).any(1)).tolist() == [5, 40]


def test_the_logarithm_is_the_way_back():
    vectors = np.concatenate(
        [FIRST[:48].as_rotvec(), np.zeros((1, 3)), np.eye(3) * 1e-7, FIRST[:12].as_rotvec() * 1e-4]
    )
    assert exponential(vectors)[1] == pytest.approx(vectors, abs=1e-6)
