"""Layouts: the same epoch for the same actors, as long as it is remembered; what is in them."""

from functools import partial

from statwalk.services.library.load import load
from statwalk.services.publish.encoder import MOST_LAYOUTS, Encoder
from statwalk.services.publish.layout import CastLayout, cast_layout
from statwalk.stage.stage import Stage
from statwalk.stage.state.frame import CastFrame


def describe(stage: Stage, cast: CastFrame) -> CastLayout:
    return cast_layout(cast, "walker", 1, lambda actor: stage.actor(actor).name)


def epoch(encoder: Encoder, stage: Stage) -> int:
    return encoder.layout(stage.frame, partial(describe, stage)).epoch


def test_the_layout_that_is_shown_is_not_forgotten_for_those_looked_at() -> None:
    walker = load("faq-walker")
    live, past = Stage(), Stage()
    live.add(walker)
    encoder = Encoder()
    first = epoch(encoder, live)
    past.add(walker)
    for _ in range(MOST_LAYOUTS + 1):
        past.add(walker)
        epoch(encoder, past)
        assert epoch(encoder, live) == first


def test_a_layout_names_what_the_numbers_of_a_frame_mean() -> None:
    stage = Stage()
    actor = stage.add(load("faq-walker"), name="Ann")
    (cast,) = stage.frame.casts
    layout = describe(stage, cast)
    assert (layout.states[cast.state[0, 0]], layout.actors[0].name) == (actor.state, "Ann")
    assert (layout.joints, len(layout.names), len(layout.parents)) == (cast.pose.translation.shape[1],) * 3
