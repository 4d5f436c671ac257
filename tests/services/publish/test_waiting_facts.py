"""Facts keep their order while they wait, and none is taken twice."""

from statwalk.services.publish.waiting_facts import WaitingFacts


def test_facts_are_taken_in_order_as_far_as_the_log_is_durable() -> None:
    facts = WaitingFacts()
    for number, texts in ((1, [b"a", b"b"]), (3, [b"c"]), (4, [b"d"])):
        facts.put(number, texts)
    taken = [facts.take(lambda number, newest=newest: number <= newest) for newest in (0, 2, 3, 3, 9)]
    assert taken == [[], [b"a", b"b"], [b"c"], [], [b"d"]]
    assert not facts


def test_a_tick_without_facts_waits_for_nothing() -> None:
    facts = WaitingFacts()
    facts.put(1, [])
    assert not facts
