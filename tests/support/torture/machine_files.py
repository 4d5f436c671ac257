"""Mutations of machine files: each is read, built on its character and played, or refused with a line."""

import re
from functools import cache, partial

from statwalk.character.character import Character
from statwalk.character.role import Role
from statwalk.errors import ContentError
from statwalk.files.machine_yaml.machine_file import KEYS, machine_of
from statwalk.services.library.load import load_shipped, shipped_machines_folder
from statwalk.stage.stage import Stage
from torture.mutator import Mutator
from torture.outcomes import SECONDS, finite, limited
from torture.text_changes import deepen, rename, text_changes

PIECE = re.compile(rb"[\w.#-]+|[{}\[\]:,|()<>=]")
NAMES = re.compile(rb"\b(?:STAT|WALK|JUMP|STUP|FORWARD|LEFT|STOP|END|pace|Hips)\b")
WORDS = [key.encode() for key in KEYS]
WORDS += b"motion loop speed markers over clips when blend buffer enter action to if match seconds".split()
WORDS += b"STAT WALK! WALK/STOP now end marker window 0.2..0.5 true no ~ [] {} 'a' *a &a !!x | nobody".split()
MOST_EVENTS = 20
"""that are sent, one after another"""
TICKS = 8
"""after the last event: more than a jump takes to begin"""


@cache
def character_of(machine: str) -> Character:
    return load_shipped(machine).character


def machine_outcome(data: bytes, machine: str) -> str:
    """Returns `read` or `refused`; raises where the reader, the compiler or a tick breaks.

    `machine`: the shipped machine whose character the file gets, whatever it names.
    """
    with limited(SECONDS):
        try:
            text, character = data.decode(), character_of(machine)
            file = machine_of(text, shipped_machines_folder() / machine)
            file.check_root(character.skeleton.names)
            role = Role.build("mutated", character, file.definition, file.root_joint)
        except UnicodeDecodeError:
            return "refused"  # such bytes are refused before they become a text
        except ContentError as refusal:
            if not refusal.place.startswith("line "):
                raise ValueError(f"no place: {refusal}") from refusal
            return "refused"
        play(role)
        return "read"


def play(role: Role) -> None:
    """Sends an actor events, one each tick, and looks at all numbers that leave the stage."""
    stage = Stage()
    stage.add(role)
    for event in role.machine.events[:-1][:MOST_EVENTS]:  # the last event is END, which is no input
        stage.send(1, event)
        stage.step(1)
    stage.step(TICKS)
    for cast in stage.frame.casts:
        finite(*cast.pose, cast.root_position, cast.heading)


def machine_mutator(character: str, *machines: str) -> Mutator:
    """The mutator of shipped machines, all of which move the character of the machine `character`."""
    folder = shipped_machines_folder()
    nest = [deepen(PIECE, b"[", b"]"), deepen(PIECE, b"{a: ", b"}")]
    return Mutator(
        lambda: [bytearray((folder / name / "machine.yaml").read_bytes()) for name in machines],
        [*text_changes(PIECE, WORDS), rename(NAMES), *nest],
        partial(machine_outcome, machine=character),
    )


MACHINE = machine_mutator("faq-walker", "faq-walker", "terrain")
LAYERS = machine_mutator("walker-layers", "walker-layers")
