"""The program: a machine as the tick reads it.

Contiguous read-only arrays; the text for their numbers is in `ProgramText`.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import from_dtype, types
from numpy.typing import DTypeLike, NDArray

from statwalk.maths.blend_tables import BLENDS, BlendTables
from statwalk.maths.compiling import read

NO_CONDITION, NO_WEIGHT = -1, -1.0


class Program(NamedTuple):
    """A machine of S states, E events (END last), L layers, A alternatives, C conditions, V variables, P
    parameters, M markers. Seconds.
    """

    target: NDArray[np.int16]
    """(S, E) the next state, or BLANK, OFF, UNDEFINED, MIXED"""
    when: NDArray[np.uint8]
    """(S, E) NOW, AT_END, AT_MARKER or IN_WINDOW"""
    marker: NDArray[np.int16]
    """(S, E) the number of the marker name that the cell waits for, -1 none"""
    opens: NDArray[np.float64]
    """(S, E) seconds into the motion at which the cell's window opens; infinite for a cell without
    a window
    """
    closes: NDArray[np.float64]
    """(S, E) seconds into the motion at which the window closes"""
    alternatives: NDArray[np.int32]
    """(S·E + 1,) the first alternative of each cell; the alternatives of a cell are adjacent"""
    to: NDArray[np.int16]
    """(A,) the state that an alternative leads to, or UNDEFINED"""
    restart: NDArray[np.uint8]
    """(A,) whether the motion begins again if the state stays the same"""
    blend: NDArray[np.float32]
    """(A,)"""
    curve: NDArray[np.uint8]
    """(A,) row of CURVES"""
    enter: NDArray[np.float64]
    """(A,) phase 0…1 at which the new motion begins, or MATCH"""
    action: NDArray[np.int16]
    """(A,) -1 none"""
    condition: NDArray[np.int16]
    """(A,) NO_CONDITION: always true"""
    weight: NDArray[np.float64]
    """(A,) its share if the cell draws, else NO_WEIGHT"""
    resume: NDArray[np.int16]
    """(A,) the history whose inner state replaces `to`, -1 none"""
    buffer: NDArray[np.float64]
    """(E,) seconds that an event waits in a blank cell"""
    received: NDArray[np.uint8]
    """(E, L) the layers that receive an input"""
    duration: NDArray[np.float64]
    """(S,) seconds of a state's motion; infinite for a state without motion"""
    loop: NDArray[np.uint8]
    """(S,)"""
    speed: NDArray[np.float64]
    """(S,) factor of time, if `speed_parameter` is -1"""
    speed_parameter: NDArray[np.int16]
    """(S,) the parameter that gives the factor of time, -1 none"""
    end_matters: NDArray[np.uint8]
    """(S,) whether END, or the idle event in its place, has a cell that may change something"""
    inside: NDArray[np.uint8]
    """(S, H) the states inside each composite state that resumes"""
    markers: NDArray[np.int32]
    """(S + 1,) the first marker of each state; the markers of a state are adjacent, by time"""
    marker_seconds: NDArray[np.float64]
    """(M,) seconds from the start of the motion"""
    marker_name: NDArray[np.int16]
    """(M,)"""
    marker_event: NDArray[np.int16]
    """(M,) the event that the marker raises; -1 if the state has no cell for it"""
    warps: NDArray[np.int32]
    """(S, S) row of the warp from the phases of one motion to the phases of another, -1 if no cell needs it;
    (0, 0) if no cell enters by MATCH
    """
    warp_loop: NDArray[np.uint8]
    """(W,) whether both motions loop"""
    warp_origin: NDArray[np.float64]
    """(W, 2) see `maths.phases.Warp`"""
    knots: NDArray[np.int32]
    """(W + 1,) the first knot of each warp"""
    knot: NDArray[np.float64]
    """(K, 2) phase of the old motion, phase of the new motion"""
    code: NDArray[np.int32]
    """(C + 1,) the first step of each condition"""
    opcode: NDArray[np.uint8]
    """(…,) steps over a stack, see `maths.formula.operations`"""
    operand: NDArray[np.float64]
    """(…,) the number, or the row of the variable"""
    asks: NDArray[np.int32]
    """(C + 1,) the first variable that each condition asks for"""
    asked: NDArray[np.int16]
    """(…,) variables, in the order of the text"""
    variable_kind: NDArray[np.int8]
    """(V,) PARAMETER for the parameters, which come first; else a row of `conditions.variables.NAMES`"""
    default: NDArray[np.float64]
    """(P,)"""
    minimum: NDArray[np.float64]
    """(P,)"""
    maximum: NDArray[np.float64]
    """(P,)"""
    omega: NDArray[np.float64]
    """(P,) 1/s, the frequency of the spring that smooths the parameter; 0: not smoothed"""
    sense_event: NDArray[np.int16]
    """(Q,) the event that each sense raises"""
    sense_when: NDArray[np.int16]
    """(Q,) the condition of each sense"""
    sense_release: NDArray[np.int16]
    """(Q,) the condition that arms the sense again; NO_CONDITION: when `sense_when` is false"""
    entry_state: NDArray[np.int16]
    """(V,) the state that keeps each entry value, in column P + v of `smoothed`"""
    entry_kind: NDArray[np.uint8]
    """(V,) its row of `conditions.variables.NAMES`"""
    initials: NDArray[np.int16]
    """(L,) the state that each layer begins in"""
    idle: NDArray[np.int16]
    """(1,) the event that stands for no input at all, -1 none"""
    blends: BlendTables
    """the clips of the states that play a blend: they give the motion its pace, see `runtime.pace`"""


class ProgramText(NamedTuple):
    """The text for the numbers of a program, for people; the tick never reads it."""

    states: tuple[str, ...]
    events: tuple[str, ...]
    variables: tuple[str, ...]
    """(V,)"""
    actions: tuple[tuple[str, tuple[str | float, ...]], ...]
    """name and arguments"""
    written: tuple[str, ...]
    """(A,) the target of each alternative as written"""
    conditions: tuple[str, ...]
    """(A,) the condition of each alternative as written, empty for none"""
    senses: tuple[str, ...]
    """(Q,) the condition of each sense as written"""
    timings: dict[tuple[int, int], str]
    """the marker (`marker NAME`) or window (`window A..B`) of the cells that have one"""
    cells: dict[tuple[int, int], tuple[str, str]]
    """the row and column of the file in which each cell is written"""


KINDS: dict[str, tuple[Any, int]] = {
    "target": (np.int16, 2),
    "when": (np.uint8, 2),
    "marker": (np.int16, 2),
    "opens": (np.float64, 2),
    "closes": (np.float64, 2),
    "alternatives": (np.int32, 1),
    "to": (np.int16, 1),
    "restart": (np.uint8, 1),
    "blend": (np.float32, 1),
    "curve": (np.uint8, 1),
    "enter": (np.float64, 1),
    "action": (np.int16, 1),
    "condition": (np.int16, 1),
    "weight": (np.float64, 1),
    "resume": (np.int16, 1),
    "buffer": (np.float64, 1),
    "received": (np.uint8, 2),
    "duration": (np.float64, 1),
    "loop": (np.uint8, 1),
    "speed": (np.float64, 1),
    "speed_parameter": (np.int16, 1),
    "end_matters": (np.uint8, 1),
    "inside": (np.uint8, 2),
    "markers": (np.int32, 1),
    "marker_seconds": (np.float64, 1),
    "marker_name": (np.int16, 1),
    "marker_event": (np.int16, 1),
    "warps": (np.int32, 2),
    "warp_loop": (np.uint8, 1),
    "warp_origin": (np.float64, 2),
    "knots": (np.int32, 1),
    "knot": (np.float64, 2),
    "code": (np.int32, 1),
    "opcode": (np.uint8, 1),
    "operand": (np.float64, 1),
    "asks": (np.int32, 1),
    "asked": (np.int16, 1),
    "variable_kind": (np.int8, 1),
    "default": (np.float64, 1),
    "minimum": (np.float64, 1),
    "maximum": (np.float64, 1),
    "omega": (np.float64, 1),
    "sense_event": (np.int16, 1),
    "sense_when": (np.int16, 1),
    "sense_release": (np.int16, 1),
    "entry_state": (np.int16, 1),
    "entry_kind": (np.uint8, 1),
    "initials": (np.int16, 1),
    "idle": (np.int16, 1),
}
"""the type and the number of axes of each array, without `blends`"""


def program(**arrays: Any) -> Program:
    """Returns the program of these arrays, each converted to its type, contiguous and read-only; `blends` as
    they are.
    """
    flat = {name: _locked(arrays[name], kind, axes) for name, (kind, axes) in KINDS.items()}
    return Program(**flat, blends=arrays["blends"])


def _locked(values: Any, kind: DTypeLike, axes: int) -> NDArray[Any]:
    array = np.array(values, kind, order="C")
    if array.ndim != axes:
        array = array.reshape((0,) * axes)
    array.flags.writeable = False
    return array


PROGRAM = types.BaseTuple.from_types(
    (*(read(from_dtype(np.dtype(kind)), axes) for kind, axes in KINDS.values()), BLENDS), Program
)
"""the numba type of a program"""
