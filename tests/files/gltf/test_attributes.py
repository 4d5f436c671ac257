import numpy as np
import pytest
from statwalk.files.gltf import attributes

UNIT = np.random.default_rng(3).normal(size=(77, 3))
UNIT = (UNIT / np.linalg.norm(UNIT, axis=1, keepdims=True)).astype(np.float32)


@pytest.mark.parametrize("row", [3, 40, 76])
@pytest.mark.parametrize("value", [(0, 0, 0), (1, 1e-2, 0), (0, 1, 1e-2), (np.nan, 0, 0)])
def test_what_is_not_of_unit_length_is_found(value, row):
    changed = UNIT.copy()
    changed[row] = value
    assert attributes.are_unit(UNIT)
    assert not attributes.are_unit(changed)


def test_vectors_may_be_in_any_order_of_memory():
    assert attributes.are_unit(np.asfortranarray(UNIT))
