"""Rules run for the bones that new values reach, and for no others: that finds what rounds over all bones
find, value by value and source by source, and a bone of a long chain takes no more rules than one of a short
chain.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest
from statwalk.character.bone_sets import bone_set_of
from statwalk.character.deduce import deduce
from statwalk.errors import ContentError
from statwalk.maths.formula.assignments import Assignment, read_assignments
from statwalk.solve import propagate as module
from statwalk.solve.bone_expressions import assign
from statwalk.solve.bone_values import BoneValue, BoneValues
from statwalk.solve.given_values import given_values
from statwalk.solve.propagate import RULES, propagate

CHANNELS = (*(f"{name}_{axis}" for name in ("rotate", "start", "end") for axis in "xyz"), "length")


def in_rounds(state: BoneValues, expressions: Sequence[Assignment] = ()) -> dict[str, BoneValue]:
    """Runs all expressions, and all rules of all bones, until nothing more is found."""
    variables: dict[str, BoneValue] = {}
    slack, order, progress = module.TOLERANCE * module._size(state), range(len(state.bones.names)), True
    while progress:
        progress = False
        for assignment in expressions:
            progress |= assign(state, variables, assignment)
        for bone in order:
            for rule in RULES:
                progress |= module._apply(state, bone, rule, slack)
        progress = progress or module._assume(state)
        order = order[::-1]
    return variables


def puzzle(seed: int) -> tuple[BoneValues, tuple[Assignment, ...]]:
    """Bones that hang on each other at random, some known values, and expressions that read each other."""
    chance = np.random.default_rng(seed)
    bones = [f"b{bone}" for bone in range(chance.integers(2, 7))]
    rows: dict[str, dict[str, Any]] = {}
    for bone, name in enumerate(bones):
        rows[name] = {"length": 1.0, "direction": (0, 1, 0)} if chance.random() < 0.7 else {}
        if bone and chance.random() < 0.9:
            rows[name]["parent"] = bones[chance.integers(bone)]
    known = {
        name: {key: chance.normal(size=3) for key in ("RA", "SP", "EP") if chance.random() < 0.15}
        for name in bones
    }
    channels = [f"{bone}.{channel}" for bone in bones for channel in CHANNELS]
    names = [str(name) for name in chance.permutation(channels)]
    count = min(25, len(names) - 2)
    names = [f"free{k}" if k < count and chance.random() < 0.15 else name for k, name in enumerate(names)]
    lines = [f"{names[k]} = {chance.choice(names[k + 1 :])} * 0.5" for k in range(count)]  # no circles
    return given_values(bone_set_of(rows), known), read_assignments(list(enumerate(lines, 1)), lambda *_: "")


def found(seed: int, run: Any) -> dict[Any, tuple[list[float], str]] | str:
    """What a puzzle's solution is; or why it has none."""
    state, expressions = puzzle(seed)
    try:
        variables = run(state, expressions)
    except ContentError as error:
        return str(error)
    every = {**state.values, **state.parts, **variables}
    return {key: (np.ravel(known.value).tolist(), known.source) for key, known in every.items()}


@pytest.mark.parametrize("first", range(0, 600, 100))
def test_due_bones_find_what_rounds_over_all_bones_find(first: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_check", lambda *_: None)
    monkeypatch.setattr(module, "check_expressions", lambda *_: None)
    for seed in range(first, first + 100):
        assert found(seed, propagate) == found(seed, in_rounds), seed


@pytest.mark.parametrize("bones", [50, 800])
def test_a_bone_of_a_long_chain_takes_no_more_rules(bones: int, monkeypatch: pytest.MonkeyPatch) -> None:
    tried, apply = [], module._apply
    monkeypatch.setattr(module, "_apply", lambda *what: tried.append(1) or apply(*what))
    rows = {f"b{bone}": {"parent": f"b{bone - 1}"} if bone else {} for bone in range(bones)}
    assert deduce(rows, {})[f"b{bones - 1}"]["RM"].rule == 4
    assert len(tried) <= 5 * len(RULES) * bones
