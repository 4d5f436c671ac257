"""Orders of collapses: what they leave, and what is wrong with them."""

import numpy as np
import pytest
from statwalk.skin.collapses import Collapses, DetailLevel, fault, level_fault


def order(vertices: list[int], onto: list[int], steps: list[int]) -> Collapses:
    return Collapses(*(np.array(values, np.uint32) for values in (vertices, onto, steps)))


def test_a_vertex_leads_on_to_the_one_that_is_left() -> None:
    chain = order([3, 2, 1], [2, 1, 0], [0, 1, 2])
    assert [chain.moved(steps, 4).tolist() for steps in (0, 2, 9)] == [
        [0, 1, 2, 3],
        [0, 1, 1, 1],
        [0, 0, 0, 0],
    ]


@pytest.mark.parametrize(
    ("vertices", "onto", "steps", "words"),
    [
        ([3, 2], [2, 1], [0, 1], ""),
        ([], [], [], ""),
        ([3, 2], [2, 1], [0], "3 vertices"),
        ([4], [1], [0], "vertex 4 of 4"),
        ([1], [4], [0], "vertex 4 of 4"),
        ([3, 3], [2, 1], [0, 1], "twice"),
        ([3, 2], [2, 3], [0, 1], "gone"),
        ([3], [3], [0], "gone"),
        ([3, 2], [2, 1], [1, 0], "fall"),
    ],
)
def test_faults(vertices: list[int], onto: list[int], steps: list[int], words: str) -> None:
    found = fault(order(vertices, onto, steps), 4)
    assert bool(found) == bool(words)
    assert words.replace("3 vertices", "2 vertices") in found


def test_levels_rise() -> None:
    assert level_fault([DetailLevel(1, 0.1), DetailLevel(2, 0.1)]) == ""
    for levels in ([(0, 0.1)], [(1, -0.1)], [(1, float("nan"))], [(2, 0.1), (2, 0.2)], [(1, 0.2), (2, 0.1)]):
        assert level_fault([DetailLevel(*level) for level in levels])
    assert "at most" in level_fault([DetailLevel(k + 1, 1.0) for k in range(1001)])
