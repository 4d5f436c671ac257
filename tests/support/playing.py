"""Roles on the tiny character from the text of a machine file, so that tests of stages can say all that a
file can.
"""

from builders import character
from statwalk.character.role import Role
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.stage.stage import Stage

STATES = """
states:
  STAND: {motion: stand, loop: true}
  WALK: {motion: walk, loop: true, speed: pace, markers: {left-down: 0.5}}
  HOP: {motion: hop}
  TURN: {motion: turn}
parameters:
  pace: {default: 1, min: 0.5, max: 2}
  stamina: {default: 8, min: 0, max: 20}
defaults: {blend: 0.2, buffer: 0.3}
"""
TABLE = """
state | GO   | HOP  | TURN | STOP  | END
STAND | WALK | HOP  | TURN | -     |
WALK  | WALK | HOP  | TURN | STAND |
HOP   |      | HOP! |      |       | STAND
TURN  |      |      |      | STAND | STAND
"""


def text_of(table=TABLE, more="", states=STATES, initial="STAND"):
    """A machine file over the tiny character."""
    rows = "".join(f"  {line}\n" for line in table.strip().splitlines())
    return f"character: c.glb\ninitial: {initial}\n{states}\ntable: |\n{rows}{more}\n"


def role_of(text, name="tiny"):
    """The role that a machine file says."""
    return Role.build(name, character(), read_machine(text, name), "hips")


def lived(text, *events, ticks=5):
    """A stage with one actor that was sent events, a few ticks apart."""
    stage = Stage()
    stage.add(role_of(text))
    for event in events:
        stage.send(1, event)
        stage.step(ticks)
    return stage
