"""What states play, as the machine knows it."""

from statwalk.machine.compile.compile_states import MotionFacts, marks_of
from statwalk.machine.definition.machine_definition import BlendDefinition


def test_markers_of_a_blend_come_before_those_of_the_clip():
    facts = MotionFacts(0.6, None, (("left", 0.3), ("clap", 0.15)))
    blend = BlendDefinition(("speed",), {}, 1, {"run": {"left": 0.2}})
    assert marks_of("run", facts, blend) == (("left", 0.2), ("clap", 0.25))
