"""The ground speed of a state's clips: a clip that walks on the spot moves its actor as fast as the ground
runs back under its feet.
"""

from __future__ import annotations

from statwalk.character.character import Character
from statwalk.character.foot_contacts import contacts_of
from statwalk.character.role_feet import feet_in
from statwalk.machine.definition.machine_definition import MachineDefinition, StateDefinition

GroundSpeed = tuple[float, float]
"""x, z (m/s) in the frame of the actor"""
STANDS: GroundSpeed = (0.0, 0.0)


def ground_speeds(
    character: Character, definition: MachineDefinition, state: StateDefinition
) -> dict[str, GroundSpeed]:
    """Returns x, z (m/s) for each clip of a state that lasts; none if the state has no ground speed.

    :raises MachineError: when the state has no clip that lasts, or the ground runs under none of its clips.
    """
    if state.ground_speed is None:
        return {}
    clips = [clip for clip in state.clips if character.clips[clip].duration > 0]
    if not clips:
        raise definition.refuse("ground_speed: the motion needs a clip that lasts", state.line)
    if state.ground_speed != "found":
        return dict.fromkeys(clips, state.ground_speed)
    contacts = contacts_of(character, feet_in(character, definition))
    drifts = {clip: contacts[clip].drift for clip in clips}
    if not any(map(any, drifts.values())):
        raise definition.refuse(
            f"ground_speed: the ground runs under no foot of {', '.join(drifts)}; write metres a second, "
            "as 1.4",
            state.line,
        )
    return {clip: (-x, -z) if x or z else STANDS for clip, (x, z) in drifts.items()}
