"""Two dozen hostile files are put to a server that runs as users run it, while a viewer watches another
stage. The control is a server that reads files where it sends frames.
"""

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from time import perf_counter
from typing import NamedTuple

import httpx
import numpy as np
import pytest
from hostile_captures import HOSTILE_CAPTURES
from paths import ASSETS
from processes import served
from torture.gltf_files import GLTF_MODEL
from torture.outcomes import memory
from watcher import Watcher
from zipped import packed

FILES, AT_A_TIME = 24, 4
LONG_GAP_SECONDS = 0.5
FRAMES_PER_FILE = 3
MIB = 1 << 20
FEW = 8
WHERE_IT_SENDS = """
from types import SimpleNamespace
from statwalk.web.routes import uploads
async def run_here(act, *arguments, limiter=None):
    return act(*arguments)
uploads.to_thread = SimpleNamespace(run_sync=run_here)
"""


class Witnessed(NamedTuple):
    """What came of the files, when which tick was seen, and the server's memory before and after, bytes."""

    statuses: list[int]
    ticks: list[int]
    seconds: list[float]
    before: int
    after: int


def hostile() -> list[bytes]:
    """Malformed files of all kinds, and mutations that may or may not be read."""
    listed = sorted(path for path in ASSETS.glob("invalid/**/*") if path.suffix in (".glb", ".gltf", ".md2"))
    odd = [packed({"a.gltf": b"{" * 100_000}), b"PK\x05\x06", b"glTF" * 1_000, bytes(MIB)]
    captured = [data for data, _ in HOSTILE_CAPTURES.values() if len(data) < MIB][::4]
    files = [*odd, *captured, *(path.read_bytes() for path in listed[:: max(1, len(listed) // 10)])]
    return [*files, *map(GLTF_MODEL.mutated, range(FILES))][:FILES]


def put(address: str, number: int, data: bytes) -> int:
    """The status of the answer to one file."""
    kind = {"content-type": "application/octet-stream"}
    return httpx.put(
        f"http://{address}/api/characters/x{number}", content=data, headers=kind, timeout=60
    ).status_code


def witness(address: str, process: int, files: list[bytes]) -> Witnessed:
    """Watch the stage `main` while the files are put, several at a time.

    Vertices are asked for first, so that the server has its compiled kernels: an idle server, too, grows by
    57 MiB while it compiles them.
    """
    httpx.get(f"http://{address}/api/stages/main/frame.glb", timeout=100).raise_for_status()
    put(address, 0, files[0])
    with Watcher(address, "/api/stages/main") as viewer, ThreadPoolExecutor(AT_A_TIME) as aside:
        viewer.frame()
        before = memory(process)
        answers = [aside.submit(put, address, number, data) for number, data in enumerate(files)]
        seen = []
        while not all(answer.done() for answer in answers):
            seen.append((viewer.frame().tick, perf_counter()))
    ticks, seconds = (list(column) for column in zip(*seen, strict=True))
    return Witnessed([answer.result() for answer in answers], ticks, seconds, before, memory(process))


@pytest.fixture(scope="module")
def witnessed(tmp_path_factory: pytest.TempPathFactory) -> Witnessed:
    with served("--data", str(tmp_path_factory.mktemp("data"))) as (process, address):
        return witness(address, process.pid, hostile())


def test_each_is_taken_or_refused(witnessed: Witnessed) -> None:
    assert {status // 100 for status in witnessed.statuses} <= {2, 4}
    assert sum(status // 100 == 4 for status in witnessed.statuses) > FILES / 2


def test_the_other_stage_is_shown_while_files_are_read(witnessed: Witnessed) -> None:
    assert len(witnessed.ticks) >= FRAMES_PER_FILE * FILES


def test_a_server_that_reads_where_it_sends_is_noticed(tmp_path: Path) -> None:
    """It sends about one frame between two files."""
    files = hostile()[:FEW]
    with served("--data", str(tmp_path), change=WHERE_IT_SENDS) as (process, address):
        seen = witness(address, process.pid, files)
    assert len(seen.ticks) < FRAMES_PER_FILE * FEW


def test_no_frame_comes_twice_or_late(witnessed: Witnessed) -> None:
    assert witnessed.ticks == sorted(set(witnessed.ticks))
    assert (
        np.quantile(np.diff(witnessed.seconds), 0.99) <= LONG_GAP_SECONDS
    )  # one in a hundred is the machine's: it may be busy


def test_the_server_s_memory_is_back_where_it_was(witnessed: Witnessed) -> None:
    assert witnessed.after - witnessed.before <= 32 * MIB
