"""The arrays of a program that say what its conditions read and how they are evaluated;
`condition_values` reads them.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from itertools import accumulate
from typing import Any

from statwalk.machine.conditions.variables import NAMES, PARAMETER
from statwalk.maths.formula.postfix import Formula


def condition_arrays(
    conditions: Collection[Formula], variables: Sequence[str], parameters: int
) -> dict[str, Any]:
    """Returns the fields of a program for its conditions; the first `parameters` of its variables are
    parameters.
    """
    codes = [condition.code(variables) for condition in conditions]
    asked = [[variables.index(name) for name in condition.variables] for condition in conditions]
    return {
        "code": list(accumulate(map(len, codes), initial=0)),
        "opcode": [opcode for code in codes for opcode, _ in code],
        "operand": [operand for code in codes for _, operand in code],
        "asks": list(accumulate(map(len, asked), initial=0)),
        "asked": [row for rows in asked for row in rows],
        "variable_kind": [PARAMETER] * parameters + [NAMES.index(name) for name in variables[parameters:]],
    }
