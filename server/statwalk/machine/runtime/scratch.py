"""Working values of the tick of one actor and layer: places in `Workspace.scratch` and `Workspace.clock`."""

(
    STATE_BEFORE,
    SEAMS,
    CROSSED,
    AT_END,
    OWED,
    ENDING,
    RESTARTED,
    CARRIED,
    CHANGES,
    ENTERED,
    DRAWS,
    FIRST_TRIED,
    PAST_TRIED,
    NOTE,
    PHASE_OF_EVENTS,
    PLACE,
    EVENT,
    SLOT,
    OTHER,
    FLEETING,
    TICK,
) = range(21)
"""STATE_BEFORE: after the tick before; SEAMS: how many seams of its loop the motion has crossed since
`passed`; CROSSED: markers of the motion count; AT_END: END came and is not yet answered; OWED: this END was
put off by a stay; ENDING: END is being answered; RESTARTED: END came, and the motion has restarted since;
CARRIED: the time left in the tick must still be added; CHANGES: number of changes; ENTERED: the state was
left, also if it was entered again; DRAWS: number of random draws; FIRST_TRIED, PAST_TRIED: the alternatives
whose conditions were tried for the current event; NOTE: the sense that raised it, -1 none; PHASE_OF_EVENTS,
PLACE: the kind of event that comes next, and the position in its list; EVENT, SLOT, OTHER, FLEETING: the
current event, its place in the queue (-1 none), the actor that it comes from, whether it is a marker; TICK:
the number of the tick
"""
SIZE_OF_SCRATCH = 24

CARRY, DT = range(2)
"""seconds left after END; seconds of a tick"""
SIZE_OF_CLOCK = 4
