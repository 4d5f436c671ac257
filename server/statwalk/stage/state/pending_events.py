"""Events that a tick raises and that count in the next tick; notices about inputs that a machine gives no
verdict on.
"""

from __future__ import annotations

from typing import NamedTuple

MOST_RAISED = 16
"""the most events that can be raised on one actor in a tick, as many as can wait; without a bound a thousand
actors could raise a million events on each other
"""
(
    NO_OTHER,
    NOBODY_KNOWS,
    NOBODY_IS_CALLED,
    TOO_MANY_RAISED,
    NO_SUCH_EVENT,
    NO_SUCH_STATE,
    STATE_IS_GONE,
    EVENT_IS_GONE,
    STATE_IS_RENAMED,
) = range(9)
"""Reasons of a notice. For `raise(EVENT, WHOM)`: NO_OTHER; NOBODY_KNOWS, no other actor's machine has the
event; NOBODY_IS_CALLED, no actor has the name; TOO_MANY_RAISED on one actor in a tick. For an input: the role
has NO_SUCH_EVENT, or NO_SUCH_STATE to travel to. For an edit: STATE_IS_GONE,
the state that the actor was in; STATE_IS_RENAMED, the state that the actor is in; EVENT_IS_GONE, a pending
event. `stage.effects.words` turns the codes into sentences when they are read
"""
NOTICE_REASONS = range(STATE_IS_RENAMED + 1)


class PendingEvent(NamedTuple):
    """An event that counts in the next tick of `actor`."""

    actor: int
    """id"""
    event: str
    other: int
    """id of the actor that touched `actor` or raised the event"""
    kind: int
    """TOUCH or RAISED"""
    point: tuple[float, float, float] | None = None
    """place of the touch, metres"""
    time: float = 0.0
    """time of the touch, 0…1 within its tick"""


class Notice(NamedTuple):
    """A notice: an event that reached no actor, or an actor that cannot take it; or what an edit did to an
    actor.
    """

    actor: int
    """id of the actor that gets the notice"""
    event: str
    """or the state, if the state does not exist"""
    other: int
    reason: int
    """NO_OTHER … STATE_IS_RENAMED"""
    layer: int = 0
    from_state: str = ""
    to_state: str = ""
    """the state of the actor after the edit"""
    target: str = ""
    """the name that no actor has"""
