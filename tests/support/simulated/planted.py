"""Faults that are planted into the product to see that the simulation finds them."""

from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, ExitStack, contextmanager
from typing import Any, NamedTuple
from unittest.mock import PropertyMock, patch

from simulated.server import Server
from statwalk.services.hosting.store.committer import Committer
from statwalk.services.hosting.store.kept_keys import KeptKeys
from statwalk.services.hosting.store.kept_log import KeptLog
from statwalk.services.hosting.store.kept_stage import KeptStage
from statwalk.services.hosting.store.writer import Writer
from statwalk.services.publish import outbox
from statwalk.services.publish.outbox import Outbox
from statwalk.stage import clock

Plant = Callable[[], AbstractContextManager[object]]


def answer_before_commit() -> AbstractContextManager[object]:
    """An input is acknowledged before the disk has it."""
    return patch.object(KeptLog, "durable", lambda *_: True)


def retry_without_looking() -> AbstractContextManager[object]:
    """A commit that failed is made again, without a look at what the file holds."""
    look = Committer._newest_in

    def newest(committer: Committer, connection: Any) -> int:
        return 0 if hasattr(committer, "committed") else look(committer, connection)

    return patch.object(Committer, "_newest_in", newest)


def no_flush_after_an_error() -> AbstractContextManager[object]:
    """What a failed commit left in the file counts, although it was never flushed."""

    def verified(committer: Committer) -> Any:
        committer._connection = committer._open_database(committer.path)
        return committer._connection

    return patch.object(Committer, "_verified", verified)


def keys_lost_at_a_start() -> AbstractContextManager[object]:
    """After a start the idempotency keys are unknown."""
    resume = KeptStage.resume

    def without_keys(kept: KeptStage, *arguments: Any) -> None:
        resume(kept, *arguments)
        kept.keys.answers.clear()

    return patch.object(KeptStage, "resume", without_keys)


def key_after_its_fork() -> AbstractContextManager[object]:
    """The key of an input to the past is kept after the fork, in another commit, and nobody reserves it."""

    @contextmanager
    def later(keys: KeptKeys, post: Any, posted: Any) -> Iterator[list[Any]]:
        yield []
        if rows := keys.rows(post, posted.tick, posted.seq, posted.stage):
            keys._writer.put(rows)

    patches = ExitStack()
    patches.enter_context(patch.object(KeptKeys, "answering", later))
    patches.enter_context(patch.object(KeptKeys, "reserved", lambda *_: ExitStack()))
    return patches


def oldest_frame_first() -> AbstractContextManager[object]:
    """The first frame that waits stays; newer ones are dropped."""
    put = Outbox.put_frame
    return patch.object(Outbox, "put_frame", lambda box, frame: box.frame or put(box, frame))


def no_credits() -> AbstractContextManager[object]:
    """Frames are sent whether they are acknowledged or not."""
    return patch.object(outbox, "CREDITS", 10**6)


def time_of_day() -> AbstractContextManager[object]:
    """The server measures durations by the time of day."""
    return patch.object(Server, "now", lambda server: server.world.wall)


def everything_caught_up() -> AbstractContextManager[object]:
    """After a stop all ticks that were missed are made at once."""
    return patch.object(clock, "LARGEST_CATCH_UP_S", float("inf"))


def notes_without_bound() -> AbstractContextManager[object]:
    """Playheads are noted every second, though the disk refuses them."""
    return patch.object(Writer, "is_behind", PropertyMock(return_value=False))


class Planted(NamedTuple):
    """A fault, for how many minutes a seed runs to find it, and at which seed the tests begin to look."""

    minutes: float
    plant: Plant
    first: int


PLANTS = {
    "answer before commit": Planted(0.5, answer_before_commit, 1),
    "retry without looking": Planted(0.5, retry_without_looking, 41),
    "no flush after an error": Planted(0.5, no_flush_after_an_error, 6),
    "keys lost at a start": Planted(0.5, keys_lost_at_a_start, 41),
    "key after its fork": Planted(1.0, key_after_its_fork, 72),
    "oldest frame first": Planted(0.5, oldest_frame_first, 6),
    "no credits": Planted(0.5, no_credits, 1),
    "time of day": Planted(0.5, time_of_day, 2),
    "everything caught up": Planted(0.5, everything_caught_up, 8),
    "notes without bound": Planted(1.0, notes_without_bound, 29),
}
