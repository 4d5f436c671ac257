"""Logs: order, shared pasts, JSON lines."""

import sys
import threading

from statwalk.stage.past.log import LogEntry, MemoryLog


def press(tick, name="GO"):
    return LogEntry(tick, "press", 1, name)


def test_entries_of_a_tick_keep_their_order():
    log = MemoryLog([press(3, "A"), press(2, "B"), press(3, "C")])
    assert [entry.name for entry in log.at(3)] == ["A", "C"]
    assert [entry.name for entry in log] == ["B", "A", "C"]


def test_a_fork_keeps_what_counts_up_to_its_tick():
    log = MemoryLog([press(1), press(2), press(3)])
    assert list(log.until(2)) == [press(1), press(2)]


def test_a_fork_and_its_origin_do_not_see_each_other():
    log = MemoryLog([press(1)])
    fork = log.until(1)
    fork.append(press(2, "FORK"))
    log.append(press(2, "ORIGIN"))
    log.append(press(1, "LATE"))
    assert [entry.name for entry in fork] == ["GO", "FORK"]


def test_a_fork_of_a_fork_keeps_both_pasts():
    fork = MemoryLog([press(1), press(5)]).until(3)
    fork.append(press(4))
    assert list(fork.until(6)) == [press(1), press(4)]


def test_a_fork_before_a_fork_keeps_only_the_first_past():
    fork = MemoryLog([press(1), press(5)]).until(5)
    assert list(fork.until(2)) == [press(1)]


def test_a_fork_can_be_read_while_its_origin_is_written():
    """Each stage of a server has a thread and a lock of its own."""
    log = MemoryLog([press(tick) for tick in range(1_000)])
    fork = log.until(1_000)
    writer = threading.Thread(target=lambda: [log.append(press(tick)) for tick in range(1_000, 30_000)])
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
