"""What one viewer may say: every message costs, whatever is in it, and forks are few."""

import json

import pytest
from anyio import CapacityLimiter
from stages import registry
from statwalk.services.cancel import CancelToken
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, StageSetup
from statwalk.services.hosting.registry import Registry
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.publish.outbox import Outbox
from statwalk.web.socket.inbox import IDLE_ACKS_PER_SECOND, INPUT_BURST, MOST_FORKS, Inbox

pytestmark = pytest.mark.anyio
CATALOGUE = Catalogue()


@pytest.fixture
def held() -> Registry:
    return registry(CATALOGUE)


@pytest.fixture
def inbox(held: Registry) -> Inbox:
    host = held.open(StageSetup(clock="manual", actors=(AddActor("faq-walker"),)))
    host.handle(ask.Step(5))
    return Inbox(host, Outbox("pose"), CancelToken(), CancelToken(), CapacityLimiter(1))


async def taken_until_cut(inbox: Inbox, message: str, most: int) -> int:
    """How many messages are taken until the viewer is cut off."""
    for count in range(most):
        await inbox.take(message)
        if inbox.outbox.closing is not None:
            assert inbox.outbox.closing[0] == "too many messages"
            return count
    raise AssertionError(f"{most} messages were taken")


WRONG = {"no type": "{}", "no json": "{", "an acknowledgement of nothing": '{"type":"ack","tick":1}'}


@pytest.mark.parametrize("message", WRONG.values(), ids=WRONG)
async def test_who_floods_with_what_means_nothing_is_cut_off(inbox: Inbox, message: str) -> None:
    """The reserve, and what comes back meanwhile: far less than as much again."""
    assert await taken_until_cut(inbox, message, 2_000) >= min(INPUT_BURST, IDLE_ACKS_PER_SECOND)


async def test_a_long_message_costs_as_much_as_many_short_ones(inbox: Inbox) -> None:
    """60 KiB cost 61 of 240: the fifth finds nothing left."""
    assert await taken_until_cut(inbox, json.dumps({"type": "x" * (60 << 10)}), 20) <= 6


async def test_acknowledging_frames_costs_nothing(inbox: Inbox) -> None:
    for tick in range(1_000):
        inbox.outbox.travelling.append((tick, 0.0))
        await inbox.take(json.dumps({"type": "ack", "tick": tick}))
    assert inbox.outbox.closing is None


async def test_one_viewer_opens_few_forks_in_a_row(inbox: Inbox, held: Registry) -> None:
    for number in range(20):
        await inbox.take(json.dumps({"type": "event", "event": "FORWARD", "tick": 0, "ref": number}))
    answers = [json.loads(text) for text in inbox.outbox.take_texts()]
    kinds = [answer["type"] for answer in answers]
    assert kinds.count("forked") == kinds.count("accepted") == MOST_FORKS
    assert {answer["status"] for answer in answers if answer["type"] == "error"} == {409}
    assert len(held.all()) == 1 + MOST_FORKS


async def test_after_many_forks_the_present_still_takes_events(inbox: Inbox) -> None:
    for tick in [0] * 10 + [None]:
        await inbox.take(json.dumps({"type": "event", "event": "FORWARD", "tick": tick}))
    assert json.loads(inbox.outbox.take_texts()[-1])["type"] == "accepted"


async def test_an_input_counts_though_the_viewer_is_gone(inbox: Inbox) -> None:
    """What it sent before it left may be read after the connection broke."""
    inbox.token.cancel()
    await inbox.take(json.dumps({"type": "event", "event": "FORWARD"}))
    inbox.host.handle(ask.Step(1))
    assert [actor.state for actor in inbox.host.handle(ask.DescribeActors())] == ["STWK"]
