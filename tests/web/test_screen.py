"""Layouts: the same epoch for the same actors, as long as it is remembered."""

from statwalk.loading import load
from statwalk.stage.stage import Stage
from statwalk.web.keeping.catalogue import Catalogue
from statwalk.web.streaming.screen import MOST_LAYOUTS, Screen


def test_the_layout_that_is_shown_is_not_forgotten_for_those_looked_at() -> None:
    walker = load("faq-walker")
    live, past = Stage(), Stage()
    live.add(walker)
    screen = Screen(Catalogue())
    epoch = screen.layout(live.frame, live).epoch
    past.add(walker)
    for _ in range(MOST_LAYOUTS + 1):
        past.add(walker)
        screen.layout(past.frame, past)
        assert screen.layout(live.frame, live).epoch == epoch
