"""Expressions as arrays (EX1): groups of assignments in postfix code, and the channels that they read and
set.

Group 0 is the machine's; a state whose motion is a pose driven by expressions has a group of its own. Every
value has a slot: frameid, time, the parameters, then the other variables and channels of all groups.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Annotated, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.columns import locked
from statwalk.maths.formula.assignments import Assignment
from statwalk.maths.formula.operations import VARIABLE

FRAME_SLOT, TIME_SLOT, FIRST_PARAMETER = 0, 1, 2
AXES = 9
"""channels of a joint: rotation, translation, scale, three each"""
NO_SLOT = -1
POWERS = 3
"""targets of a muscle at most: the contraction, its square, its cube"""


class ExpressionTables(NamedTuple):
    """G groups, A assignments, T touched joints and M touched morph weights of all groups."""

    group: Annotated[NDArray[np.int32], "state"]
    """the group of each state's motion, 0: its motion is no expression"""
    first_assignment: Annotated[NDArray[np.int32], "group"]
    """(G + 1,)"""
    first_step: Annotated[NDArray[np.int32], "assignment"]
    """(A + 1,)"""
    slot: Annotated[NDArray[np.int32], "assignment"]
    """the slot that each assignment sets"""
    opcode: Annotated[NDArray[np.uint8], "step"]
    operand: Annotated[NDArray[np.float64], "step"]
    first_joint: Annotated[NDArray[np.int32], "group"]
    """(G + 1,)"""
    joint: Annotated[NDArray[np.int32], "touched"]
    load: Annotated[NDArray[np.int32], "touched, channel"]
    """(T, 9) the slots that take a channel's value before the group runs, NO_SLOT none"""
    store: Annotated[NDArray[np.int32], "touched, channel"]
    """(T, 9) the slots whose values a channel takes afterwards, NO_SLOT none"""
    first_weight: Annotated[NDArray[np.int32], "group"]
    """(G + 1,)"""
    weight: Annotated[NDArray[np.int32], "weight"]
    """(M,) the channel of a pose that holds each morph weight"""
    weight_load: Annotated[NDArray[np.int32], "weight"]
    weight_store: Annotated[NDArray[np.int32], "weight"]
    """(M,) the slots that take a morph weight and that it takes, NO_SLOT none"""
    contraction: Annotated[NDArray[np.int32], "muscle, power"]
    """(K, 3) the channels of a pose that hold the contraction of each muscle, its square and its cube,
    NO_SLOT none
    """


class JointChannel(NamedTuple):
    """A channel of a joint: the axis is 0…8."""

    joint: int
    axis: int


class WeightChannel(NamedTuple):
    """The channels of a pose that hold the weights of the morph targets of one name; all are set, the first
    is read.
    """

    channels: tuple[int, ...]


class ExpressionProgram(NamedTuple):
    """The tables, and what their memory must hold."""

    tables: ExpressionTables
    lines: tuple[Assignment, ...]
    """the assignments of group 0 that files have, in the order in which they run"""
    slots: Mapping[str, int]
    """the slot of each name that group 0 sets: channels and free variables"""
    values: int
    """number of slots"""
    deepest: int
    """the most numbers on the stack"""


def expression_program(
    groups: Sequence[Sequence[Assignment]],
    group_of_state: Sequence[int],
    channels: Mapping[str, JointChannel | WeightChannel],
    parameters: Sequence[str],
    contractions: Sequence[Sequence[int]] = (),
) -> ExpressionProgram:
    """Returns the program of groups of sorted assignments; `channels` has all names that are channels,
    `contractions` are the rows of `ExpressionTables.contraction`.
    """
    builder = _Builder(channels, parameters)
    for assignments in groups:
        builder.add(assignments)
    lines = tuple(line for line in groups[0] if not line.follows)
    slots = {line.target: builder.slot_of(0, line.target) for line in lines}
    tables, deepest = builder.tables(group_of_state, contractions), max(builder.deepest, 1)
    return ExpressionProgram(tables, lines, slots, builder.count, deepest)


class _Builder:
    """The columns of the tables so far."""

    def __init__(
        self, channels: Mapping[str, JointChannel | WeightChannel], parameters: Sequence[str]
    ) -> None:
        self.channels = channels
        self.fixed = {"frameid": FRAME_SLOT, "time": TIME_SLOT} | {
            name: FIRST_PARAMETER + row for row, name in enumerate(parameters)
        }
        self.count = FIRST_PARAMETER + len(parameters)
        self.deepest = 0
        self.own: dict[tuple[int, str], int] = {}
        self.first_assignment, self.first_step, self.first_joint = [0], [0], [0]
        self.slots: list[int] = []
        self.code: list[tuple[int, float]] = []
        self.touched: list[tuple[int, list[int], list[int]]] = []
        self.first_weight, self.weights = [0], list[tuple[int, int, int]]()

    def slot_of(self, group: int, name: str) -> int:
        """Returns the slot of a name in a group; a new one for a name that is not yet known there."""
        if name in self.fixed:
            return self.fixed[name]
        if (group, name) not in self.own:
            self.own[group, name] = self.count
            self.count += 1
        return self.own[group, name]

    def add(self, assignments: Sequence[Assignment]) -> None:
        """Adds a group."""
        group = len(self.first_assignment) - 1
        for assignment in assignments:
            formula = assignment.formula
            slots = [self.slot_of(group, name) for name in formula.scope]
            for opcode, operand in formula.code(formula.scope):
                self.code.append((opcode, float(slots[int(operand)]) if opcode == VARIABLE else operand))
            self.deepest = max(self.deepest, len(formula.steps))
            self.slots.append(self.slot_of(group, assignment.target))
            self.first_step.append(len(self.code))
        self.first_assignment.append(len(self.slots))
        self._touch(group, assignments)

    def _touch(self, group: int, assignments: Sequence[Assignment]) -> None:
        """Adds the joints and morph weights whose channels the group reads or sets."""
        names_set = {line.target for line in assignments}
        read = {name for line in assignments for name in line.formula.scope} - names_set
        rows: dict[int, tuple[list[int], list[int]]] = {}
        for name in (*sorted(read), *sorted(names_set)):
            channel = self.channels.get(name)
            if isinstance(channel, WeightChannel):
                self._touch_weights(channel, self.slot_of(group, name), is_set=name in names_set)
            elif channel is not None:
                joint, axis = channel
                row = rows.setdefault(joint, ([NO_SLOT] * AXES, [NO_SLOT] * AXES))
                row[name in names_set][axis] = self.slot_of(group, name)
        for joint, (load, store) in sorted(rows.items()):
            self._complete(load, store)
            self.touched.append((joint, load, store))
        self.first_joint.append(len(self.touched))
        self.first_weight.append(len(self.weights))

    def _touch_weights(self, weight: WeightChannel, slot: int, *, is_set: bool) -> None:
        if is_set:
            self.weights += [(channel, NO_SLOT, slot) for channel in weight.channels]
        else:
            self.weights.append((weight.channels[0], slot, NO_SLOT))

    def _complete(self, load: list[int], store: list[int]) -> None:
        """Keeps the angles that are not set where others of the joint are."""
        if any(slot != NO_SLOT for slot in store[:3]):
            for axis in range(3):
                if store[axis] == NO_SLOT:
                    if load[axis] == NO_SLOT:
                        load[axis] = self.count
                        self.count += 1
                    store[axis] = load[axis]

    def tables(
        self, group_of_state: Sequence[int], contractions: Sequence[Sequence[int]]
    ) -> ExpressionTables:
        """Returns the arrays."""

        def rows(column: int) -> NDArray[np.int32]:
            return np.array([row[column] for row in self.touched], np.int32).reshape(-1, AXES)

        return locked(
            ExpressionTables(
                group=np.array(group_of_state, np.int32),
                first_assignment=np.array(self.first_assignment, np.int32),
                first_step=np.array(self.first_step, np.int32),
                slot=np.array(self.slots, np.int32),
                opcode=np.array([opcode for opcode, _ in self.code], np.uint8),
                operand=np.array([operand for _, operand in self.code], np.float64),
                first_joint=np.array(self.first_joint, np.int32),
                joint=np.array([joint for joint, _, _ in self.touched], np.int32),
                load=rows(1),
                store=rows(2),
                first_weight=np.array(self.first_weight, np.int32),
                weight=np.array([channel for channel, _, _ in self.weights], np.int32),
                weight_load=np.array([load for _, load, _ in self.weights], np.int32),
                weight_store=np.array([store for _, _, store in self.weights], np.int32),
                contraction=np.array(contractions, np.int32).reshape(-1, POWERS),
            )
        )  # fmt: skip
