"""Keeps the bones and the expressions that may find something new. All other bones and expressions have seen
every known value (FAQ Q26).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from statwalk.maths.formula.assignments import Assignment
from statwalk.solve.bone_expressions import channel_of
from statwalk.solve.bone_values import BoneValue, BoneValues


class DueBones:
    """A bone is due if a value of its own or of its parent is new since its rules ran; an expression, if a
    bone or a variable that it names has a new value.
    """

    def __init__(
        self, state: BoneValues, variables: Mapping[str, BoneValue], expressions: Sequence[Assignment]
    ) -> None:
        """Marks all bones and all expressions as due."""
        count = len(state.bones.names)
        self.state, self.variables, self.bones = state, variables, set(range(count))
        self.children: list[list[int]] = [[] for _ in range(count)]
        for bone, parent in enumerate(state.bones.parent.tolist()):
            if parent >= 0:
                self.children[parent].append(bone)
        self.expressions = [(assignment, self._named(assignment)) for assignment in expressions]
        self.news: set[int | str] = set().union(*(named for _, named in self.expressions))

    def _named(self, assignment: Assignment) -> frozenset[int | str]:
        """The bones, and the variables, that an expression names."""
        names = (assignment.target, *assignment.formula.scope)
        places = [(name, channel_of(self.state.bones, name)) for name in names]
        return frozenset(name if place is None else place[0] for name, place in places)

    def note_changes(self) -> None:
        """Marks the bones and the expressions that new values reach as due."""
        for bone in self.state.changed:
            self.bones.add(bone)
            self.bones.update(self.children[bone])
        self.news |= self.state.changed
        self.state.changed.clear()

    def take_expressions(self) -> Iterator[Assignment]:
        """Yields the expressions that are due, in their order; what an expression finds counts for those
        behind it, and for the next call.
        """
        news, self.news = self.news, set()
        for assignment, named in self.expressions:
            if not (news.isdisjoint(named) and self.news.isdisjoint(named)):
                known = len(self.variables)
                yield assignment
                self.note_changes()
                if len(self.variables) > known:
                    self.news.add(assignment.target)
