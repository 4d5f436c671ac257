"""A small machine in text, and what an operation changes of it, line by line."""

import difflib
from collections.abc import Sequence

from statwalk.files.machine_yaml.edit.edited import edited
from statwalk.files.machine_yaml.edit.operations import EditOperation
from statwalk.files.machine_yaml.machine_file import read_machine

DOOR = """# A door, and who guards it.
title: A door      # for people
initial: SHUT
defaults: {blend: 0.3, buffer: 0}
parameters:
  pace: {default: 1, min: 0, max: 2}
  wind: {default: 0, min: 0, max: 1, smooth: 0.2}   # of the draught

states:
  SHUT:    {motion: shut, loop: true}
  OPENING: {motion: open, markers: {half: 0.5}}     # slowly
  OPEN:
    motion:                                         # it swings
      over: wind
      clips: {still: 0, swing: 1}
    loop: true
  GUARD:
    machine:
      initial: STAND
      states: {STAND: {motion: stand}, BOW: {motion: bow, final: true}}
      table: |
        state | HAIL
        STAND | BOW
        BOW   | OPEN at end
layers:
  lamp:
    initial: OFF
    weight: wind
    states: {OFF: {motion: none}, LIT: {motion: glow}}
    table: |
      state | PUSH
      OFF   | LIT
table: |
  state   | PUSH    | PULL | HAIL  | half | END
  SHUT    | OPENING | -    | GUARD |      |
  OPENING | SHUT at half |      |       | SHUT | OPEN
  OPEN    |         | SHUT |       |      |
  GUARD   | SHUT    |      |       |      | SHUT

# What a cell says beyond the next state.
cells:
  SHUT/PUSH:  {blend: 0.5, action: "raise(PULL, all)"}
  OPEN/PUSH:  [{if: wind > 0.5, to: SHUT}, {to: OPEN}]
  OPEN/HAIL:  {SHUT: 4, OPENING: 1}
  "*/PULL":   {to: GUARD.BOW, when: marker half}
senses:
  HAIL: {when: pace > 1, release: pace < 0.5}
keys:
  ArrowUp: {hold: PUSH, release: PULL}
  w:       {change: {OPEN: {wind: 1}}}
properties:
  - OPEN only after OPENING
  - from SHUT, PUSH reaches OPEN within 2 s
expressions: |
  # the wind of pace
  Hinge.rotate_y = wind * 30 + pace
view:
  base:
    OPEN: [10, 20]
"""


def lines(*operations: EditOperation, text: str = DOOR) -> list[str]:
    """The lines that go (-) and come (+); what is left must be a machine that can be read."""
    after = edited(text, operations)
    read_machine(after)
    return [line for line in difflib.ndiff(text.splitlines(), after.splitlines()) if line[0] in "+-"]


def came(*operations: EditOperation, text: str = DOOR) -> list[str]:
    """The lines that come."""
    return [line[2:] for line in lines(*operations, text=text) if line[0] == "+"]


def after(operations: Sequence[EditOperation], text: str = DOOR) -> str:
    """The text after operations; it must be a machine that can be read."""
    changed = edited(text, operations)
    read_machine(changed)
    return changed
