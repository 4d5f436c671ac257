"""Newest frame wins, facts keep their order, three credits, five seconds."""

import asyncio

import pytest
from statwalk.web.streaming.mailbox import MOST_FACTS, Layout, Mailbox, Shown

LAYOUT = Layout(1, ())


def frame(tick: int) -> Shown:
    return Shown(tick, "pose", LAYOUT, b"")


@pytest.fixture
def mailbox() -> Mailbox:
    return Mailbox("pose")


def test_the_newest_frame_wins(mailbox: Mailbox) -> None:
    for tick in (1, 2, 3):
        mailbox.put_frame(frame(tick))
    assert mailbox.take_frame(0.0) == frame(3)
    assert mailbox.take_frame(0.0) is None
    assert mailbox.skipped == 2


def test_no_more_than_three_frames_travel(mailbox: Mailbox) -> None:
    taken = []
    for tick in range(10):
        mailbox.put_frame(frame(tick))
        taken.append(mailbox.take_frame(0.0))
    assert [shown.tick for shown in taken if shown] == [0, 1, 2]


def test_an_acknowledgement_counts_for_the_frames_before_it(mailbox: Mailbox) -> None:
    for tick in (1, 2, 3):
        mailbox.put_frame(frame(tick))
        mailbox.take_frame(0.0)
    mailbox.put_frame(frame(4))
    mailbox.acknowledge(2)
    assert [tick for tick, _ in mailbox.travelling] == [3]
    assert mailbox.take_frame(0.0) == frame(4)


def test_an_acknowledgement_of_what_was_never_sent_counts_for_nothing(mailbox: Mailbox) -> None:
    mailbox.put_frame(frame(1))
    mailbox.take_frame(0.0)
    mailbox.acknowledge(99)
    assert len(mailbox.travelling) == 1


def test_overdue_after_five_seconds(mailbox: Mailbox) -> None:
    mailbox.put_frame(frame(1))
    mailbox.take_frame(100.0)
    assert not mailbox.overdue(105.0)
    assert mailbox.overdue(105.1)
    mailbox.acknowledge(1)
    assert not mailbox.overdue(1_000.0)


def test_facts_come_once_in_order_and_the_status_last(mailbox: Mailbox) -> None:
    mailbox.put_status(b"old")
    mailbox.put_facts([b"1", b"2"])
    mailbox.put_facts([b"3"])
    mailbox.put_status(b"new")
    assert mailbox.take_texts() == [b"1", b"2", b"3", b"new"]
    assert mailbox.take_texts() == []


def test_too_many_facts_cut_the_viewer_off_rather_than_lose_one(mailbox: Mailbox) -> None:
    mailbox.put_facts([b"fact"] * MOST_FACTS)
    mailbox.put_facts([b"one more"])
    assert mailbox.closing == (4008, "too many messages wait")


def test_a_filled_mailbox_wakes_its_writer(mailbox: Mailbox) -> None:
    async def wait_for_mail() -> bool:
        asyncio.get_running_loop().call_soon(mailbox.put_frame, frame(1))
        return await mailbox.filled.wait()

    assert asyncio.run(wait_for_mail())
