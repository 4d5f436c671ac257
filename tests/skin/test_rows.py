import numpy as np
import pytest
from statwalk.skin import rows
from statwalk.skin.deform import surface
from statwalk.skin.primitive import Primitive

UP = np.array([[0.0, 1, 0]], np.float32)


def turned(linear):
    """The normal +Y of a rigid part's only vertex, under a joint's matrix."""
    world = np.concatenate([np.array(linear, np.float32), np.zeros((3, 1), np.float32)], axis=1)[None]
    return (
        surface([Primitive(0, 0, 0, 0, np.zeros((1, 3), np.float32), UP)], [])
        .posed_parts(world, np.zeros(0, np.float32))[0]
        .normals[0]
    )


@pytest.mark.parametrize(
    ("linear", "expected"),
    [
        (np.diag([1, -1, 1]), [0, -1, 0]),
        (np.diag([-1, 1, 1]), [0, 1, 0]),
        (np.diag([1e-12, 1e-12, 1e-12]), [0, 1, 0]),
        (np.diag([1, 0, 1]), [0, 1, 0]),
        (np.zeros((3, 3)), [0, 1, 0]),
        ([[1, 1, 0], [0, 1, 0], [0, 0, 1]], [0, 1, 0]),
        ([[1, 0, 0], [1, 1, 0], [0, 0, 1]], [-np.sqrt(0.5), np.sqrt(0.5), 0]),
        ([[1, 0, 0], [0, 1, 0], [0, 1, 1]], [0, 1, 0]),
    ],
    ids=[
        "mirrored along",
        "mirrored across",
        "tiny",
        "flattened",
        "vanished",
        "sheared along x",
        "sheared along y",
        "sheared along z",
    ],
)
def test_normals_stay_unit_and_right(linear, expected):
    assert turned(linear) == pytest.approx(expected, abs=1e-6)


def test_a_vector_without_length_becomes_what_is_said_instead():
    assert rows.unit(np.zeros((3, 1)), np.zeros((3, 1)))[:, 0].tolist() == [0, 0, 1]
