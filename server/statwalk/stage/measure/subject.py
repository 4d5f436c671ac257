"""What is measured of a role: its feet, hands, skin and joints, and how lively its motions are."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property

import numpy as np

from statwalk.character.feet import Foot
from statwalk.character.role import Role
from statwalk.character.skin_points import SkinPoints, outermost_points
from statwalk.errors import UnknownNameError
from statwalk.machine.compile.alternatives import NOW
from statwalk.machine.definition.ground_definition import GroundDefinition
from statwalk.machine.model_checker.work import Checkpoint, go_on
from statwalk.machine.travel import reachable
from statwalk.maths.arrays import Floats, Ints
from statwalk.stage.measure.jump import joints_shown, most_of
from statwalk.stage.measure.limbs import hands_of
from statwalk.stage.measure.measured_ground import Spot, places_on
from statwalk.stage.measure.over_ground import most_over

Cell = tuple[int, int]
"""row and column of the table"""


class Subject:
    """A role that is measured; its parts are made on first use. `checkpoint` is called between the pieces of
    the work, and ends it by raising.
    """

    def __init__(self, role: Role, checkpoint: Checkpoint = go_on) -> None:
        self.role, self.checkpoint = role, checkpoint
        self._most: dict[int, Floats] = {}

    @cached_property
    def unlocked(self) -> Role:
        """Returns the role without foot lock, which would hold feet elsewhere than the new motion puts them:
        no transition would ever arrive. Without it nothing finds the ground.
        """
        return replace(self.role, definition=replace(self.role.definition, foot_lock=0.0, ground=()))

    @cached_property
    def feet(self) -> tuple[Foot, ...]:
        """Returns the feet."""
        return self.role.feet

    @cached_property
    def skin(self) -> SkinPoints:
        """Returns the points of the skin that could sink into the floor."""
        feet = [joint for foot in self.feet for joint in foot.joints]
        return outermost_points(self.role.character, feet)

    @cached_property
    def hands(self) -> Ints:
        """Returns the joints of the hands."""
        return hands_of(self.role.character)

    @cached_property
    def joints(self) -> Ints:
        """Returns the joints whose jumps count."""
        return joints_shown(self.role)

    @cached_property
    def names(self) -> list[str]:
        """Returns the names of `joints`."""
        return [self.role.character.skeleton.names[joint] for joint in self.joints]

    @cached_property
    def ground(self) -> tuple[GroundDefinition, ...]:
        """Returns the pieces of uneven ground."""
        return self.role.definition.ground

    @cached_property
    def places(self) -> list[Spot]:
        """Returns where trials begin."""
        return places_on(self.ground)

    def most(self, state: int) -> Floats:
        """Returns (2, J) the largest changes of position and velocity within a state's motion by itself; on
        uneven ground, within the same motion over it.
        """
        if state not in self._most:
            most = most_of(self.role, state, self.joints)
            if self.ground:
                over = most_over(self.role, state, self.joints, self.places, self.checkpoint)
                most = np.maximum(most, over)
            self._most[state] = most
        return self._most[state]

    @cached_property
    def cells(self) -> list[Cell]:
        """Returns the cells that change the state or restart its motion, in states that can be reached."""
        machine = self.role.machine
        known = {machine.states[machine.initial], *reachable(machine, machine.initial)}
        rows = [
            row
            for row, name in enumerate(machine.states)
            if (name in known or machine.layer_of[row]) and self.role.motions[row] is not None
        ]
        return [
            (row, column)
            for row in rows
            for column in range(len(machine.events))
            if self.changes(row, column)
        ]

    @property
    def motions(self) -> list[int]:
        """Returns the states whose motions are measured by themselves."""
        return sorted({row for row, _ in self.cells})

    def name(self, cell: Cell) -> str:
        """Returns `STATE/EVENT`."""
        return f"{self.role.machine.states[cell[0]]}/{self.role.machine.events[cell[1]]}"

    def cell(self, name: str) -> Cell:
        """Returns the cell with a name, `STATE/EVENT`.

        :raises UnknownNameError: when no cell that changes the state has this name.
        """
        names = {self.name(cell): cell for cell in self.cells}
        if name not in names:
            raise UnknownNameError("cell that changes the state", name, names)
        return names[name]

    def line(self, row: int, event: str) -> int:
        """Returns the line of the cell of a state and an event in the machine file; of the state if `event`
        is empty, or the file does not say.
        """
        machine = self.role.machine
        definition = self.role.resolved[machine.layer_of[row]].definition
        source = machine.sources.get((row, machine.events.index(event))) if event else None
        cell = definition.cells.get(source) if source else None
        line: int = (cell or definition.states[machine.states[row]]).line
        return line

    def changes(self, row: int, column: int) -> bool:
        """Returns whether a cell may change the state or restart its motion."""
        alternatives = self.role.machine.alternatives.get((row, column), ())
        return any(option.target >= 0 and (option.target != row or option.restart) for option in alternatives)

    def interruptions(self, row: int, column: int) -> list[int]:
        """Returns the events that change the state which a cell leads to at once; none if the cell does not
        blend, or leads to one of several states.
        """
        machine = self.role.machine
        options = machine.alternatives[row, column]
        target = options[0].target
        if len(options) > 1 or options[0].blend <= 0:
            return []
        at_once = np.flatnonzero(machine.when[target] == NOW).tolist()
        return [other for other in at_once if other != machine.end and self.changes(target, other)]
