"""Roles whose machine files have solvers, on the shipped walker's body: he stands, he walks."""

import statwalk
from statwalk.character.role import Role
from statwalk.files.machine_yaml.machine_file import read_machine

TEXT = """\
character: faq-walker
initial: STAT
defaults: {{blend: 0.4, buffer: 0}}
states:
  STAT: {{motion: stand, loop: true}}
  WALK: {{motion: walk, loop: true}}
parameters:
  grip: {{kind: point, default: [-0.35, 1.2, 0.3]}}
  part: {{default: 1, min: 0, max: 1}}
  side: {{kind: direction, default: [0, 0, -1]}}
solvers:
{solvers}
table: |
  state | GO   | STOP
  STAT  | WALK | STAT
  WALK  | WALK | STAT
"""
ARM = "[Right.upperarm, Right.lowerarm, Right.hand]"


def text_of(*solvers):
    """The text of a machine file with these solvers, each a line `NAME: {...}`."""
    return TEXT.format(solvers="\n".join(f"  {solver}" for solver in solvers))


def role_of(*solvers, root="Root"):
    """The role of that file."""
    walker = statwalk.load("faq-walker").character
    return Role.build("reacher", walker, read_machine(text_of(*solvers)), root)


def joint(actor, name):
    """The place of a joint on the stage."""
    return actor.world[actor.role.character.skeleton.index(name), :3, 3]
