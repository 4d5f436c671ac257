"""Rows in any order become a skeleton, parents first; what cannot be sorted is refused by name and place."""

import locked_arrays
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from statwalk.errors import TextError, UnknownNameError
from statwalk.rig.skeleton import Skeleton


def test_children_may_come_first():
    skeleton, order = Skeleton.sorted(["hand", "arm", "root"], ["arm", "root", None])
    assert skeleton.names == ("root", "arm", "hand")
    assert skeleton.parent.tolist() == [-1, 0, 1]
    assert order.tolist() == [2, 1, 0]


@given(st.permutations(range(12)))
def test_every_order_of_the_rows_gives_parents_first(order):
    names = [f"bone{i}" for i in range(12)]
    parents = [None if i == 0 else f"bone{(i - 1) // 2}" for i in range(12)]
    skeleton, rows = Skeleton.sorted([names[i] for i in order], [parents[i] for i in order])
    assert (skeleton.parent < np.arange(12)).all()
    assert [skeleton.names[p] if p >= 0 else None for p in skeleton.parent] == [
        parents[order[row]] for row in rows
    ]


def test_a_chain_of_5000_is_sorted_without_recursion():
    names = [str(i) for i in range(5000)]
    skeleton, _ = Skeleton.sorted(names, [*names[1:], None])
    assert skeleton.names[0] == "4999"
    assert skeleton.parent.tolist() == list(range(-1, 4999))


@pytest.mark.parametrize(
    ("names", "parents", "message"),
    [
        (["a", "b", "a"], [None, "a", "b"], "line 9: a is defined twice, first at line 7"),
        (["arm", "hand"], [None, "amr"], "line 8: no bone is called 'amr'; did you mean arm?"),
        (["a", "b", "c"], [None, "c", "b"], "line 8: bones form a cycle: b -> c -> b"),
        (["a"], ["a"], "line 7: bones form a cycle: a -> a"),
    ],
)
def test_what_cannot_be_sorted_is_refused(names, parents, message):
    with pytest.raises(TextError, match=message.replace("?", r"\?")):
        Skeleton.sorted(names, parents, ["line 7", "line 8", "line 9"])


def test_index_of_an_unknown_name_lists_those_that_exist():
    skeleton, _ = Skeleton.sorted(["Root", "Head"], [None, "Root"])
    assert skeleton.index("Head") == 1
    with pytest.raises(UnknownNameError, match="Root, Head"):
        skeleton.index("Tail")


def test_index_of_a_name_that_a_model_uses_twice_is_the_first():
    assert Skeleton(("Root", "Bone", "Bone"), np.array([-1, 0, 1], np.int32)).index("Bone") == 1


def test_its_arrays_cannot_be_written():
    parent = np.array([-1, 0], np.int32)
    locked_arrays.check(Skeleton(("a", "b"), parent))
    parent[1] = -1  # the skeleton has its own
