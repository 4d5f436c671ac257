"""The feet and the foot contacts of a role: as found, with the corrections of its machine file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from statwalk.character.character import Character
from statwalk.character.feet import Foot, feet_of
from statwalk.character.foot_contacts import ClipContacts, FootContact, contacts_of
from statwalk.errors import MachineError, UnknownNameError
from statwalk.machine.definition.feet_definition import ContactDefinition, FootDefinition
from statwalk.machine.definition.machine_definition import MachineDefinition


def check_feet(character: Character, definition: MachineDefinition) -> None:
    """Checks the names in `feet` and `contacts`, without looking at the skin or the clips.

    :raises MachineError: when a joint, a clip or a foot does not exist; with the line.
    """
    for foot in definition.feet.values():
        try:
            for joint in _joints(foot).values():
                character.skeleton.index(joint)
        except UnknownNameError as error:
            raise definition.refuse(f"feet: {error}", foot.line) from None
    if definition.contacts:
        _check_contacts(character, definition)


def _check_contacts(character: Character, definition: MachineDefinition) -> None:
    feet = feet_in(character, definition)
    names = [name for foot in feet for name in (foot.name, character.skeleton.names[foot.ankle])]
    for clip, spans in definition.contacts.items():
        for name, contact in spans.items():
            if clip not in character.clips:
                raise _unknown(definition, "clip", clip, character.clips, contact.line)
            if name not in names:
                raise _unknown(definition, "foot", name, names, contact.line)


def _unknown(
    definition: MachineDefinition, kind: str, name: str, names: Mapping[str, object] | list[str], line: int
) -> MachineError:
    return definition.refuse(f"contacts: {UnknownNameError(kind, name, names)}", line)


def feet_in(character: Character, definition: MachineDefinition) -> tuple[Foot, ...]:
    """Returns the feet of a character, with the joints that a machine names."""
    return feet_of(character, {name: _joints(foot) for name, foot in definition.feet.items()})


def _joints(foot: FootDefinition) -> dict[str, str]:
    """The names of the joints that a machine gives for a foot."""
    joints = {"hip": foot.hip, "knee": foot.knee, "ankle": foot.ankle, "toe": foot.toe}
    return {part: joint for part, joint in joints.items() if joint}


def contacts_in(
    character: Character, definition: MachineDefinition, feet: tuple[Foot, ...]
) -> dict[str, ClipContacts]:
    """Returns the contacts of all clips, by clip; corrected contacts are those of the whole foot, of its heel
    and of its ball.
    """
    found = contacts_of(character, feet)
    return {
        clip: _corrected(character, contacts, feet, definition.contacts.get(clip, {}))
        for clip, contacts in found.items()
    }


def _corrected(
    character: Character,
    contacts: ClipContacts,
    feet: tuple[Foot, ...],
    corrections: Mapping[str, ContactDefinition],
) -> ClipContacts:
    parts = []
    for foot, part in zip(feet, contacts.feet, strict=True):
        named = corrections.get(foot.name) or corrections.get(character.skeleton.names[foot.ankle])
        parts.append(FootContact(foot.name, *[named.spans] * 3) if named else part)
    return replace(contacts, feet=tuple(parts))
