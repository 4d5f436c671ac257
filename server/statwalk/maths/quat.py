"""Quaternions (…, 4) in the order x y z w, unit length, over any leading axes; float32 and float64 stay.

Rotations act on column vectors: `rotate(mul(a, b), v) == rotate(a, rotate(b, v))`. Interpolation is FAQ Q17;
see `curves` for splines. Products are written out element by element: one actor and a thousand get the same
bits.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from statwalk.maths import vector
from statwalk.maths.arrays import Floats, floats
from statwalk.maths.elementary import atan2, polynomial, sincos

IDENTITY = np.array([0.0, 0.0, 0.0, 1.0])
IDENTITY.setflags(write=False)

_SMALLEST = {"f": 1e-36, "d": 1e-300}  # added to a square before its root, so that 0/0 does not arise
_CONJUGATE = np.array([-1, -1, -1, 1], np.int8)
# row i: the component of b (and its sign) that multiplies component i of a, for x y z w of the product
_MUL = np.array([[3, 2, 1, 0], [2, 3, 0, 1], [1, 0, 3, 2], [0, 1, 2, 3]])
_MUL_SIGN = np.array([[1, -1, 1, -1], [1, 1, -1, -1], [-1, 1, 1, -1], [1, 1, 1, 1]], np.int8)
# sin(sqrt q)/sqrt q on 0..(pi/2)^2, and the square of the angle from e = 1 - cos(angle/2), divided by e; by
# precision
SINE = {
    "f": (1.0, -0.16666657944392216, 0.008333050086778936, -0.0001980901106705217, 2.605092957769762e-06),
    "d": (
        0.9999999999999999, -0.16666666666666072, 0.008333333333282726, -0.00019841269824853736,
        2.7557316608034622e-06, -2.5051881879351066e-08, 1.6048166167666442e-10, -7.374360691567403e-13,
    ),
}  # fmt: skip
_ANGLE_SQUARED = {
    "f": (
        8.000000087973428, 1.3333183519785923, 0.35595968596575156, 0.11052687316026907, 0.05443013518985956,
    ),
    "d": (
        7.9999999999999964, 1.333333333335623, 0.35555555529845206, 0.11428572545116569, 0.04063467528239257,
        0.015395096951786104, 0.006065759584276669, 0.0025949260476301242, 0.0007430765967922,
        0.0008664796676696652,
    ),
}  # fmt: skip


def dot(a: Floats, b: Floats) -> Floats:
    """Returns a · b over the four components -> (…)."""
    products = a * b
    return products[..., 0] + products[..., 1] + products[..., 2] + products[..., 3]


def mul(a: Floats, b: Floats) -> Floats:
    """Returns the product a b: the rotation b first, then a."""
    terms = a[..., :, None] * (b.take(_MUL, -1) * _MUL_SIGN)
    return terms[..., 0, :] + terms[..., 1, :] + terms[..., 2, :] + terms[..., 3, :]


def conjugate(q: Floats) -> Floats:
    """Returns the inverse rotation of a unit quaternion."""
    return q * _CONJUGATE


def rotate(q: Floats, v: Floats) -> Floats:
    """Returns the vectors `v` (…, 3) rotated by `q`: v + 2w(u×v) + 2u×(u×v)."""
    axis = q[..., :3]
    turned = 2 * vector.cross(axis, v)
    return v + q[..., 3:] * turned + vector.cross(axis, turned)


def normalize(q: Floats) -> Floats:
    """Returns `q` at unit length; zero becomes the identity."""
    size = np.sqrt(dot(q, q))[..., None]
    if size.all():
        return q / size
    is_zero = size == 0
    return np.where(is_zero, IDENTITY.astype(q.dtype), q / np.where(is_zero, 1, size))


def from_axis_angle(axis: ArrayLike, angle: ArrayLike) -> Floats:
    """Returns the rotation by `angle` radians (…) about the unit `axis` (…, 3), right-handed."""
    sine, cosine = sincos(floats(angle) * 0.5)
    scaled = floats(axis) * sine[..., None]
    return np.concatenate([scaled, np.broadcast_to(cosine[..., None], (*scaled.shape[:-1], 1))], -1)


def from_euler_xyz(angles: ArrayLike) -> Floats:
    """Returns the rotation by the FAQ's angles (…, 3) radians: about the parent's X first, then Y, then Z, R
    = Rz·Ry·Rx.
    """
    sine, cosine = sincos(floats(angles) * 0.5)
    (sx, sy, sz), (cx, cy, cz) = np.moveaxis(sine, -1, 0), np.moveaxis(cosine, -1, 0)
    parts = (
        sx * cy * cz - cx * sy * sz,
        cx * sy * cz + sx * cy * sz,
        cx * cy * sz - sx * sy * cz,
        cx * cy * cz + sx * sy * sz,
    )
    return np.stack(parts, -1)


def to_euler_xyz(q: Floats) -> Floats:
    """Returns angles (…, 3) radians with `from_euler_xyz(angles) == ±q`; Y in −π/2…π/2, and Z = 0 if Y is
    ±π/2 (gimbal lock).
    """
    m = to_matrix(q)
    level = np.sqrt(m[..., 0, 0] * m[..., 0, 0] + m[..., 1, 0] * m[..., 1, 0])
    is_locked = level < np.sqrt(np.finfo(m.dtype).eps)
    x = np.where(is_locked, atan2(-m[..., 1, 2], m[..., 1, 1]), atan2(m[..., 2, 1], m[..., 2, 2]))
    z = np.where(is_locked, 0, atan2(m[..., 1, 0], m[..., 0, 0]))
    return np.stack([x, atan2(-m[..., 2, 0], level), z], -1).astype(m.dtype, copy=False)


# The nine entries of a rotation matrix are the identity plus two of the sixteen products q_i q_j, each with a
# sign; [column, row].
_FIRST = np.array([[5, 1, 2], [1, 0, 6], [2, 6, 0]])
_SECOND = np.array([[10, 11, 7], [11, 10, 3], [7, 3, 5]]).T
_FIRST_SIGN = np.array([[-2, 2, 2], [2, -2, 2], [2, 2, -2]], np.int8)
_SECOND_SIGN = np.array([[-2, -2, 2], [2, -2, -2], [-2, 2, -2]], np.int8).T
_EYE = np.eye(3, dtype=np.int8)


def to_matrix(q: Floats) -> Floats:
    """Returns the rotation matrices (…, 3, 3), acting on column vectors, of unit quaternions.

    Components lead in memory (the result is a transposed view), so that a crowd is few long rows instead of
    many short ones.
    """
    by_component = np.ascontiguousarray(q.T)
    products = (by_component[:, None] * by_component).reshape(16, *by_component.shape[1:])
    cells = (3, 3, *(1,) * (q.ndim - 1))
    entries, others = products.take(_FIRST, 0), products.take(_SECOND, 0)
    entries *= _FIRST_SIGN.reshape(cells)
    others *= _SECOND_SIGN.reshape(cells)
    entries += others
    entries += _EYE.reshape(cells)
    return entries.T


def from_matrix(m: Floats) -> Floats:
    """Returns the unit quaternions of rotation matrices (…, 3, 3), by the largest of the four components
    (Shepperd).
    """
    xx, yy, zz = m[..., 0, 0], m[..., 1, 1], m[..., 2, 2]
    xy, xz, yz = m[..., 0, 1] + m[..., 1, 0], m[..., 0, 2] + m[..., 2, 0], m[..., 1, 2] + m[..., 2, 1]
    xw, yw, zw = m[..., 2, 1] - m[..., 1, 2], m[..., 0, 2] - m[..., 2, 0], m[..., 1, 0] - m[..., 0, 1]
    squares = np.stack([1 + xx - yy - zz, 1 - xx + yy - zz, 1 - xx - yy + zz, 1 + xx + yy + zz], -1)
    x2, y2, z2, w2 = np.moveaxis(squares, -1, 0)
    rows = np.stack([x2, xy, xz, xw, xy, y2, yz, yw, xz, yz, z2, zw, xw, yw, zw, w2], -1).reshape(
        *squares.shape, 4
    )
    largest = squares.argmax(-1)[..., None, None]
    return normalize(np.take_along_axis(rows, largest, -2)[..., 0, :])


def from_rotation_vector(v: Floats) -> Floats:
    """Returns the rotation about `v` (…, 3) by |v| radians (exponential map)."""
    angle = np.sqrt(vector.dot(v, v) + _SMALLEST[v.dtype.char])
    sine, cosine = sincos(angle * 0.5)
    return np.concatenate([v * (sine / angle)[..., None], cosine[..., None]], -1)


def to_rotation_vector(q: Floats) -> Floats:
    """Returns axis times angle (…, 3), radians, along the shorter arc: |v| <= π (logarithm)."""
    axis = q[..., :3]
    sine = np.sqrt(vector.dot(axis, axis) + _SMALLEST[q.dtype.char])
    angle = 2 * atan2(sine, np.abs(q[..., 3]))
    size: Floats = np.copysign(angle / sine, q[..., 3])
    return axis * size[..., None]


def align(a: Floats, b: Floats) -> Floats:
    """Returns `b` or −`b`, the same rotation, whichever is nearer to `a`."""
    return np.where(dot(a, b)[..., None] < 0, -b, b)


def nlerp(a: Floats, b: Floats, f: ArrayLike) -> Floats:
    """Interpolates from `a` (f = 0) to `b` (f = 1) along the shorter arc, linearly and then normalised; f
    (…). KF3.
    """
    part = np.asarray(f, a.dtype)[..., None]
    return normalize(a * (1 - part) + align(a, b) * part)


def slerp(a: Floats, b: Floats, f: ArrayLike) -> Floats:
    """Interpolates from `a` (f = 0) to `b` (f = 1) along the shorter arc at constant angular speed; f (…) in
    0…1.

    KF4, Shoemake 1985.
    """
    cosine = dot(a, b)
    first, second = _arc_weights(np.abs(cosine), np.asarray(f, a.dtype))
    return a * first[..., None] + b * np.copysign(second, cosine)[..., None]


def _arc_weights(cosine: Floats, f: Floats) -> tuple[Floats, Floats]:
    """sin((1−f)θ)/sin θ and sin(fθ)/sin θ for cos θ in 0…1.

    Everything is a polynomial in θ², which is smooth at θ = 0: no acos, no division by a small sine, no
    special case.
    """
    kind = cosine.dtype.char
    shape = (1,) * (cosine.ndim - f.ndim) + f.shape
    fractions = np.empty((3, *shape), cosine.dtype)
    fractions[0], fractions[1], fractions[2] = 1 - f, f, 1
    lack = 1 - np.sqrt(0.5 + 0.5 * cosine)
    angle_squared = lack * polynomial(lack, _ANGLE_SQUARED[kind])
    sines = fractions * polynomial(fractions * fractions * angle_squared, SINE[kind])
    first, second, whole = sines
    return first / whole, second / whole


def arc(cosine: Floats) -> tuple[Floats, Floats]:
    """Returns θ² and θ / sin θ (…) for cos θ (…) in 0…1: the part of slerp that does not depend on the
    fraction.
    """
    kind = cosine.dtype.char
    lack = 1 - np.sqrt(0.5 + 0.5 * cosine)
    angle_squared = lack * polynomial(lack, _ANGLE_SQUARED[kind])
    return angle_squared, 1 / polynomial(angle_squared, SINE[kind])


def between(u: Floats, v: Floats) -> Floats:
    """Returns the shortest rotation from unit vector `u` to unit vector `v` (…, 3); opposite vectors rotate
    about any axis at right angles.
    """
    half = np.concatenate([vector.cross(u, v), (1 + vector.dot(u, v))[..., None]], -1)
    around = np.concatenate([vector.perpendicular(u), np.zeros_like(u[..., :1])], -1)
    is_opposite = dot(half, half)[..., None] < (1e-12 if half.dtype == np.float32 else 1e-28)
    return normalize(np.where(is_opposite, around, half))
