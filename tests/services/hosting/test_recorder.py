"""A recording can be given up at any time."""

from statwalk.services.hosting.recorder import recorded
from statwalk.services.library.load import load
from statwalk.stage.stage import Stage


def test_a_recording_looks_at_its_token_after_its_last_tick_too() -> None:
    """The keys that are needed are chosen then, which takes longer than the ticks."""
    stage, looks = Stage(), []
    stage.add(load("faq-walker"))
    stage.step(100)
    stage.before_tick = lambda: looks.append(stage.tick)
    recorded(stage, 1, 100)
    assert looks.count(100) > 2
