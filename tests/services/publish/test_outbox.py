"""Newest frame wins, facts keep their order, three credits, five seconds."""

import asyncio

import pytest
from statwalk.services.publish.layout import FrameLayout
from statwalk.services.publish.outbox import MOST_FACTS, EncodedFrame, Outbox

LAYOUT = FrameLayout(1, ())


def frame(tick: int) -> EncodedFrame:
    return EncodedFrame(tick, "pose", LAYOUT, b"")


@pytest.fixture
def outbox() -> Outbox:
    return Outbox("pose")


def test_the_newest_frame_wins(outbox: Outbox) -> None:
    for tick in (1, 2, 3):
        outbox.put_frame(frame(tick))
    assert outbox.take_frame(0.0) == frame(3)
    assert outbox.take_frame(0.0) is None
    assert outbox.skipped == 2


def test_no_more_than_three_frames_travel(outbox: Outbox) -> None:
    taken = []
    for tick in range(10):
        outbox.put_frame(frame(tick))
        taken.append(outbox.take_frame(0.0))
    assert [shown.tick for shown in taken if shown] == [0, 1, 2]


def test_an_acknowledgement_counts_for_the_frames_before_it(outbox: Outbox) -> None:
    for tick in (1, 2, 3):
        outbox.put_frame(frame(tick))
        outbox.take_frame(0.0)
    outbox.put_frame(frame(4))
    outbox.acknowledge(2)
    assert [tick for tick, _ in outbox.travelling] == [3]
    assert outbox.take_frame(0.0) == frame(4)


def test_an_acknowledgement_of_what_was_never_sent_counts_for_nothing(outbox: Outbox) -> None:
    outbox.put_frame(frame(1))
    outbox.take_frame(0.0)
    outbox.acknowledge(99)
    assert len(outbox.travelling) == 1


def test_overdue_after_five_seconds(outbox: Outbox) -> None:
    outbox.put_frame(frame(1))
    outbox.take_frame(100.0)
    assert not outbox.overdue(105.0)
    assert outbox.overdue(105.1)
    outbox.acknowledge(1)
    assert not outbox.overdue(1_000.0)


def test_facts_come_once_in_order_and_the_status_last(outbox: Outbox) -> None:
    outbox.put_newest("status", b"old")
    outbox.put_facts([b"1", b"2"])
    outbox.put_facts([b"3"])
    outbox.put_newest("status", b"new")
    assert outbox.take_texts() == [b"1", b"2", b"3", b"new"]
    assert outbox.take_texts() == []


def test_too_many_facts_cut_the_viewer_off_rather_than_lose_one(outbox: Outbox) -> None:
    outbox.put_facts([b"fact"] * MOST_FACTS)
    outbox.put_facts([b"one more"])
    assert outbox.closing == ("slow", "too many messages are pending")


def test_a_filled_mailbox_wakes_its_writer(outbox: Outbox) -> None:
    async def wait_for_mail() -> bool:
        asyncio.get_running_loop().call_soon(outbox.put_frame, frame(1))
        return await outbox.filled.wait()

    assert asyncio.run(wait_for_mail())
