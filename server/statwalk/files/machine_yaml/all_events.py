"""The columns of a machine: the events of all tables, of `events` and of senses."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from statwalk.files.machine_yaml import inputs, levels
from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.definition.machine_definition import (
    END,
    EventDefinition,
)
from statwalk.machine.definition.sense_definition import SenseDefinition, TouchDefinition


def all_events(
    entries: Mapping[str, Node],
    flats: Sequence[levels.FlatStates],
    sensed: Mapping[str, SenseDefinition | TouchDefinition],
) -> dict[str, EventDefinition]:
    """Returns the columns: the events of the first table, of `events`, of the other tables, and of senses."""
    tables = [
        level.table.table.events
        for flat in flats
        for level in reversed(flat.levels)
        if level.table is not None
    ]
    events = {
        event: EventDefinition(line) for event, line in tables[0].items() if event != END
    } | inputs.events(entries.get("events"))
    for table in tables[1:]:
        events |= {
            event: EventDefinition(line)
            for event, line in table.items()
            if event != END and event not in events
        }
    return events | {
        event: EventDefinition(sense.line) for event, sense in sensed.items() if event not in events
    }
