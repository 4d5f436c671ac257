"""Logs: order, shared pasts, JSON lines."""

import sys
import threading

from statwalk.stage.history.log import MemoryLog
from statwalk.stage.state.commands import Press


def log_of(*presses):
    """A log of presses: ticks, or ticks with the name of the event."""
    log = MemoryLog()
    for one in presses:
        tick, name = one if isinstance(one, tuple) else (one, "GO")
        log.append(tick, [Press(1, name)])
    return log


def said(log):
    return [(entry.tick, entry.command.event) for entry in log]


def test_entries_of_a_tick_keep_their_order():
    log = log_of((3, "A"), (2, "B"), (3, "C"))
    assert [entry.command.event for entry in log.at(3)] == ["A", "C"]
    assert said(log) == [(2, "B"), (3, "A"), (3, "C")]


def test_numbers_rise_as_commands_come():
    log = log_of(3, 2)
    assert log.append(3, [Press(1, "A"), Press(1, "B")]) == [3, 4]


def test_what_was_appended_is_durable_and_nothing_after_it():
    log = log_of(1, 2)
    assert (log.durable(2), log.durable(3)) == (True, False)


def test_a_fork_keeps_what_counts_up_to_its_tick():
    assert said(log_of(1, 2, 3).until(2)) == [(1, "GO"), (2, "GO")]


def test_a_fork_and_its_origin_do_not_see_each_other():
    log = log_of(1)
    fork = log.until(1)
    fork.append(2, [Press(1, "FORK")])
    log.append(2, [Press(1, "ORIGIN")])
    log.append(1, [Press(1, "LATE")])
    assert said(fork) == [(1, "GO"), (2, "FORK")]


def test_a_fork_gives_no_number_twice():
    log = log_of(1, 2)
    assert log.until(1).append(2, [Press(1, "GO")]) == [3]


def test_a_fork_takes_waiting_entries_along_under_their_numbers():
    log = log_of(1, 2, (3, "WAITS"), (4, "LATER"))
    fork = log.until(2, takes_waiting=True)
    log.append(2, [Press(1, "LATE")])
    assert [(entry.number, entry.tick) for entry in fork] == [(1, 1), (2, 2), (3, 3)]


def test_a_fork_of_a_fork_keeps_both_pasts():
    fork = log_of(1, 5).until(3)
    fork.append(4, [Press(1, "GO")])
    assert said(fork.until(6)) == [(1, "GO"), (4, "GO")]


def test_a_fork_before_a_fork_keeps_only_the_first_past():
    assert said(log_of(1, 5).until(5).until(2)) == [(1, "GO")]


def test_a_fork_can_be_read_while_its_origin_is_written():
    """Each stage of a server has a thread and a lock of its own."""
    log = log_of(*range(1_000))
    fork = log.until(1_000)
    writer = threading.Thread(
        target=lambda: [log.append(tick, [Press(1, "GO")]) for tick in range(1_000, 30_000)]
    )
    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    try:
        writer.start()
        read = {len(list(fork))}
        while writer.is_alive():
            read.add(len(list(fork)))
    finally:
        sys.setswitchinterval(before)
        writer.join()
    assert read == {1_000}
