"""`statwalk serve` as a process: its address, its refusals, and its end with viewers connected and one
stalled.
"""

import os
import signal
import socket
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import httpx
import pytest
import tiny_model
import typer
from processes import command, served
from serving import PATIENCE, open_and_never_read, wait_for
from statwalk.cli.serve import serve
from watcher import Watcher
from websockets.exceptions import ConnectionClosed

MAIN = "/api/stages/main"


def test_sigterm_ends_it_with_viewers_connected_and_one_stalled() -> None:
    with served() as (process, address):
        stalled = open_and_never_read(address, f"{MAIN}/stream?frames=glb")
        viewers = [Watcher(address, MAIN) for _ in range(5)]
        viewers[0].frame_from(viewers[0].frame().tick + 60)
        process.send_signal(signal.SIGTERM)
        assert process.wait(timeout=PATIENCE) == 0
        for viewer in viewers:
            with pytest.raises(ConnectionClosed) as closed:
                viewer.text("nothing")
            assert closed.value.rcvd is not None
            assert closed.value.rcvd.code == 1012
        stalled.close()


def test_sigterm_ends_it_in_the_middle_of_a_long_step() -> None:
    with (
        served() as (process, address),
        ThreadPoolExecutor(1) as aside,
        httpx.Client(base_url=f"http://{address}", timeout=60) as rest,
    ):
        stage = rest.post(
            "/api/stages", json={"clock": "manual", "actors": [{"machine": "faq-walker"}] * 100}
        ).headers["Location"]
        step = aside.submit(httpx.post, f"http://{address}{stage}/step", json={"ticks": 36_000}, timeout=60)
        wait_for(lambda: rest.get(stage).json()["tick"] > 0)
        process.send_signal(signal.SIGTERM)
        assert (
            process.wait(timeout=PATIENCE) == 0
        )  # 1.5 s on a quiet machine; without a look at the token it was minutes
        answer = step.result()
    assert (answer.status_code, answer.json()["detail"]) == (
        503,
        "the work is cancelled: its client disconnected, or the server stops",
    )


SIGNALLED_EARLY = """
import signal, uvicorn
from statwalk.web.app import create_app
from statwalk.web.server import listening_socket, run
serve = uvicorn.Server.run
uvicorn.Server.run = lambda server, sockets: (signal.raise_signal(signal.SIGTERM), serve(server, sockets))
run(create_app(), listening_socket("127.0.0.1", 0))
"""


def test_a_signal_before_uvicorn_listens_for_it_counts() -> None:
    assert subprocess.run([sys.executable, "-c", SIGNALLED_EARLY], timeout=PATIENCE).returncode == 0


def test_the_page_and_the_default_machine_are_there() -> None:
    with served() as (_, address):
        page = httpx.get(f"http://{address}/", timeout=PATIENCE)
        main = httpx.get(f"http://{address}{MAIN}", timeout=PATIENCE).json()
    assert page.headers["content-type"].startswith("text/html")
    assert (main["clock"], main["actors"][0]["machine"]) == ("real", "faq-walker")


@pytest.mark.parametrize("host", ["127.0.0.2", "::1", "localhost"])
def test_it_answers_at_the_loopback_address_that_you_name(host: str) -> None:
    with served("--host", host) as (_, address):
        assert httpx.get(f"http://{address}{MAIN}", timeout=PATIENCE).status_code == 200


def test_uploads_are_kept_in_the_data_folder(tmp_path: Path) -> None:
    with served("--data", str(tmp_path)) as (_, address):
        headers = {"content-type": "model/gltf-binary"}
        assert (
            httpx.put(
                f"http://{address}/api/characters/tiny",
                content=tiny_model.model(),
                headers=headers,
                timeout=PATIENCE,
            ).status_code
            == 201
        )
    with served("--data", str(tmp_path)) as (_, address):
        assert httpx.get(f"http://{address}/api/characters/tiny", timeout=PATIENCE).status_code == 200


def refused(*arguments: str) -> str:
    """What it says when it ends with status 2."""
    ended = subprocess.run(
        command(*arguments),
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        env=os.environ | {"COLUMNS": "200"},
    )
    assert ended.returncode == 2
    return ended.stderr


@pytest.mark.parametrize("host", ["0.0.0.0", "::", "192.168.1.1", "evil.example", ""])
def test_other_machines_are_not_served(host: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(typer.Exit) as ended:
        serve(host=host)
    assert ended.value.exit_code == 2
    assert "other computers" in capsys.readouterr().err


def test_a_port_in_use_is_named() -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = str(taken.getsockname()[1])
        assert port in refused("--port", port)


def test_a_folder_without_a_machine_is_named(tmp_path: object) -> None:
    assert str(tmp_path) in refused(str(tmp_path), "--port", "0")


def test_an_unknown_name_is_refused_as_a_folder() -> None:
    assert "tentacel" in refused("tentacel", "--port", "0")


@pytest.mark.parametrize("name", ["tentacle", "playground"])
def test_a_shipped_name_is_what_the_page_opens_on(name: str, tmp_path: Path) -> None:
    command = [sys.executable, "-m", "statwalk.cli", "serve", name, "--port", "0", "--data", str(tmp_path)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        address = process.stdout.readline().split("http://")[1].split("/")[0]
        machines = {
            actor["machine"]
            for actor in httpx.get(f"http://{address}/api/stages/main", timeout=PATIENCE).json()["actors"]
        }
        process.terminate()
    assert any(machine.startswith(name) for machine in machines)
