"""R-05 on a real server: stages in real time, with few and many viewers, killed and started again, against
their logs played as fast as possible.
"""

import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from random import Random
from typing import NamedTuple

import httpx
from processes import served
from random_sessions import role_of
from serving import wait_for
from statwalk.services.publish.pose_message import HEADER
from statwalk.stage.replay import replay
from watcher import Watcher
from websockets.exceptions import ConnectionClosed

POSTS = 12
FRAMES, LATER_FRAMES = 40, 20
"""that each stage is to show before the kill, and after the start"""
PATIENCE = 60.0

Frame = tuple[int, str]
"""a tick, and the hash that a viewer was told"""


class Live(NamedTuple):
    """How many stages lived, how many frames viewers saw, and what was wrong with them."""

    stages: int
    frames: int
    wrong: list[str]


def live(folder: Path, contents: Sequence[str], seed: int, viewers: int) -> Live:
    """Opens a real-time stage for each machine, the first with many viewers, posts to them, kills the server,
    starts it again, and compares all that was seen with the logs.
    """
    chance, data = Random(seed), ("--data", str(folder))
    with served(*data) as (process, address):
        stages = [_opened(address, content, chance) for content in contents]
        crowds = [viewers if number == 0 else 1 for number in range(len(stages))]
        with watched(address, dict(zip(stages, crowds, strict=True))) as before:
            _post(address, stages, contents, chance)
            wait_for(lambda: all(len(frames) >= FRAMES for frames in before.values()), PATIENCE)
            process.kill()
    with served(*data) as (_, address), watched(address, dict.fromkeys(stages, 1)) as after:
        wait_for(lambda: all(len(frames) >= LATER_FRAMES for frames in after.values()), PATIENCE)
        logs = {
            stage: httpx.get(f"http://{address}/api/stages/{stage}/log", timeout=PATIENCE).text
            for stage in stages
        }
    seen = {stage: before[stage] | after[stage] for stage in stages}
    wrong = [each for stage, log in logs.items() for each in unlike(stage, log.splitlines(), seen[stage])]
    return Live(len(stages), sum(map(len, seen.values())), wrong)


def unlike(stage: str, lines: list[str], seen: set[Frame]) -> list[str]:
    """The frames that the log does not lead to; several hashes of a tick are several frames."""
    again = replay(lines, role_of, until=0)
    found = {0: again.hash}
    while again.tick < max(tick for tick, _ in seen):
        again.step()
        found[again.tick] = again.hash
    return [
        f"{stage}: tick {tick} is {found[tick]}, and was {old}" for tick, old in seen if found[tick] != old
    ]


@contextmanager
def watched(address: str, viewers: dict[str, int]) -> Iterator[dict[str, set[Frame]]]:
    """What the viewers of each stage see, while they watch."""
    frames: dict[str, set[Frame]] = {stage: set() for stage in viewers}
    with ExitStack() as stack:
        for stage, count in viewers.items():
            for _ in range(count):
                stack.enter_context(_watching(address, stage, frames[stage].add))
        yield frames


@contextmanager
def _watching(address: str, stage: str, told: Callable[[Frame], None]) -> Iterator[None]:
    """A viewer in a thread, until the end of the block or of the server."""
    ended = threading.Event()
    watcher = Watcher(address, f"/api/stages/{stage}")

    def watch() -> None:
        with suppress(ConnectionClosed, TimeoutError):
            while not ended.is_set():
                _, _, tick, _, digest, _, _ = HEADER.unpack_from(watcher.data())
                told((tick, f"{digest:016x}"))

    thread = threading.Thread(target=watch, daemon=True)
    thread.start()
    try:
        yield
    finally:
        ended.set()
        thread.join(PATIENCE)
        with suppress(ConnectionClosed):
            watcher.socket.close()


def _opened(address: str, content: str, chance: Random) -> str:
    """A stage with an actor, in real time; its id."""
    place = {"position": [0, 0, 0], "heading_deg": chance.uniform(-180, 180)}
    setup = {"seed": chance.getrandbits(31), "actors": [{"machine": content, **place}]}
    answer = httpx.post(f"http://{address}/api/stages", json=setup, timeout=PATIENCE)
    assert answer.status_code == 201, answer.text
    return answer.json()["id"]


def _post(address: str, stages: Sequence[str], contents: Sequence[str], chance: Random) -> None:
    """Posts events to the stages in turn, whenever the answer to the one before is there."""
    with httpx.Client(base_url=f"http://{address}", timeout=PATIENCE) as rest:
        for _ in range(POSTS):
            for stage, content in zip(stages, contents, strict=True):
                if events := role_of(content).machine.events[:-1]:
                    event = {
                        "event": chance.choice(events),
                        "kind": chance.choice(("press", "hold", "release")),
                    }
                    answer = rest.post(f"/api/stages/{stage}/events", json=event)
                    assert answer.status_code == 202, answer.text
