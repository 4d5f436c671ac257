"""Facts keep their order while they wait, and none is taken twice."""

from statwalk.services.publish.waiting_facts import WaitingFacts


def test_facts_are_taken_in_order_as_far_as_their_ticks_are_durable() -> None:
    facts = WaitingFacts()
    for tick, texts in ((1, [b"a", b"b"]), (3, [b"c"]), (4, [b"d"])):
        facts.put(tick, texts)
    taken = [facts.take(lambda tick, newest=newest: tick <= newest) for newest in (0, 2, 3, 3, 9)]
    assert taken == [[], [b"a", b"b"], [b"c"], [], [b"d"]]
    assert not facts


def test_a_tick_without_facts_waits_for_nothing() -> None:
    facts = WaitingFacts()
    facts.put(1, [])
    assert not facts
