"""What the verifier finds in a table."""

from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.compile.compile_machine import MotionFacts
from statwalk.machine.verify import verify
from ticking import text_of


def found(table, states="A B", more="", motions=None):
    """(kind, message) of each finding."""
    ticks = dict.fromkeys(states.split(), 60)
    facts = None if motions is None else {name: MotionFacts(seconds) for name, seconds in motions.items()}
    return [(one.kind, one.message) for one in verify(read_machine(text_of(table, ticks, more)), facts)]
