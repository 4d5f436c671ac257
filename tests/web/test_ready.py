"""Once the server says that it is ready, nothing is compiled: not for a character, an upload, a frame or a
recording.
"""

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest
import tiny_model
from statwalk.maths import code_folder
from statwalk.maths.prepare import kernels_by_module
from statwalk.services.library.load import shipped_machines_folder
from watcher import Watcher

SERVER = """
import sys
from numba.core import event
from statwalk.cli import main

class Compilations(event.Listener):
    def on_start(self, started):
        print("compiles", started.data["dispatcher"], file=sys.stderr, flush=True)
    def on_end(self, ended):
        pass

class Imports:
    def find_spec(self, name, path=None, target=None):
        print("imports", name, file=sys.stderr, flush=True)

event.register("numba:compile", Compilations())
sys.meta_path.insert(0, Imports())
sys.argv = ["statwalk", "serve", *sys.argv[1:]]
main()
"""


WALKER = "/api/machines/faq-walker"
WRITTEN = "WALK/LEFT:    {enter: match, blend: 0.25}"
FORMULA = "WALK/LEFT: [{if: sin(time) < 2 and speed * speed >= 0 or phase % 0.5 > 2, to: TLFT}]"
TEXT = (shipped_machines_folder() / "faq-walker" / "machine.yaml").read_text(encoding="utf-8")
assert WRITTEN in TEXT


def asks(method: str, path: str, body: Any = None, version: str = "") -> tuple[str, str, Any, str]:
    return method, path, body, version


REQUESTS = [  # in this order: 1 is the faq-walker of the stage
    asks("POST", "{stage}/events", {"event": "FORWARD", "actor": 1}),
    asks("POST", "{stage}/step", {"ticks": 30}),
    asks("GET", "{stage}/frame.glb"),
    asks("GET", "{stage}/recording.glb"),
    asks("GET", "{stage}/actors/1/why?tick=1"),
    asks("GET", "{stage}/actors/1/whynot?event=JUMP&tick=20"),
    asks("GET", "/api/machines/faq-printed/verify"),
    asks("GET", "/api/machines/tiny/verify"),
    asks("PATCH", f"{WALKER}/cells", {"state": "WALK", "event": "LEFT", "text": "TRGT"}, "1"),
    asks("PUT", WALKER, {"text": TEXT.replace(WRITTEN, FORMULA)}, "2"),
    asks("GET", f"{WALKER}/verify"),
    asks("POST", "{stage}/step", {"ticks": 60}),
    asks("POST", "{stage}/events", {"event": "LEFT", "actor": 1}),
    asks("POST", "{stage}/step", {"ticks": 10}),
    asks("GET", "{stage}/actors/1/why?tick=91"),
    asks("GET", "{stage}/actors/1/whynot?event=JUMP&tick=95"),
    asks("POST", "{stage}/actors/1/travel", {"state": "CRCH"}),
    asks("POST", "{stage}/step", {"ticks": 100}),
    asks("DELETE", "{stage}/actors/1/travel"),
    asks("POST", f"{WALKER}/undo", None, "3"),
    asks("POST", "{stage}/seek", {"tick": 70}),
    asks("GET", "{stage}/frame.glb?tick=40"),
    asks("POST", "{stage}/fork"),
    asks("POST", "{stage}/events", {"event": "STOP", "actor": 1}),
    asks("POST", "{stage}/seek", {"tick": 200}),
    asks("GET", "{stage}/history"),
    asks("GET", "{stage}/facts"),
    asks("GET", "{stage}/log"),
    asks("POST", "/api/stages", {"scene": "playground"}),
]


@pytest.fixture
def served(tmp_path: Path) -> Iterator[tuple[str, Path]]:
    """The address, and a file that gets a line for every compilation and import from now on."""
    told = tmp_path / "told"
    environment = os.environ | {"COLUMNS": "200", "PYTHONUNBUFFERED": "1"}
    command = [sys.executable, "-c", SERVER, "--port", "0", "--data", str(tmp_path / "data")]
    with (
        told.open("w") as errors,
        subprocess.Popen(
            command, stdout=subprocess.PIPE, stderr=errors, text=True, env=environment
        ) as process,
    ):
        assert process.stdout is not None
        address = process.stdout.readline().split("http://")[1].split("/")[0]
        assert "imports statwalk.skin._kernels" in told.read_text()
        os.truncate(told, 0)
        os.lseek(errors.fileno(), 0, os.SEEK_SET)
        yield address, told
        process.send_signal(signal.SIGTERM)


def kept_code() -> dict[str, int]:
    """The files of compiled code and when they were written, by the server or by a child of it; not the
    marker that says that all are there, which another process may write later.
    """
    files = [path for path in code_folder.folder().iterdir() if path.name != "complete"]
    return {path.name: path.stat().st_mtime_ns for path in files}


def use_everything(address: str) -> None:
    """A stage of one's own with an uploaded model that becomes a machine, all REQUESTS, frames of both
    kinds.
    """
    with httpx.Client(base_url=f"http://{address}", timeout=60) as rest:
        upload = {"content": tiny_model.model(), "headers": {"content-type": "model/gltf-binary"}}
        rest.put("/api/characters/tiny", **upload).raise_for_status()
        rest.post("/api/machines", json={"name": "tiny", "character": "tiny"}).raise_for_status()
        actors = [{"machine": "faq-walker"}, {"machine": "tiny"}]
        opened = rest.post("/api/stages", json={"clock": "manual", "actors": actors}).raise_for_status()
        for request in REQUESTS:
            method, path = request[0], request[1].format(stage=opened.headers["Location"])
            body, headers = request[2], {"If-Match": request[3]}
            rest.request(method, path, json=body, headers=headers).raise_for_status()
        for frames in ("pose", "glb"):
            with Watcher(address, "/api/stages/main", frames) as watcher:
                assert all(watcher.data() for _ in range(3))


def test_no_request_waits_for_a_compiler(served: tuple[str, Path]) -> None:
    address, told = served
    before = kept_code()
    use_everything(address)
    lines = told.read_text().splitlines()
    assert [line for line in lines if line.startswith("compiles")] == []
    assert not {line.split()[1] for line in lines if line.startswith("imports")} & {
        "numba",
        *kernels_by_module(code_folder.PACKAGE),
    }
    assert kept_code() == before
