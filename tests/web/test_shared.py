"""`statwalk serve` as others reach it: over TLS, with tokens, and with a log that keeps secrets."""

import asyncio
import os
import signal
import ssl
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import httpx
import pytest
from certificates import certificate_in
from serving import PATIENCE
from statwalk.services.access.access_file import AccessFile
from websockets.asyncio.client import connect
from websockets.exceptions import InvalidStatus

GUESS = "a-secret-that-is-in-an-address"


class Running(NamedTuple):
    """A server over TLS: its process, its address, the token of its start, who trusts its certificate."""

    process: "subprocess.Popen[str]"
    address: str
    token: str
    trust: ssl.SSLContext
    data: Path
    log: Path

    def rest(self, **options: object) -> httpx.Client:
        return httpx.Client(
            base_url=f"https://{self.address}", verify=self.trust, timeout=PATIENCE, **options
        )


@pytest.fixture(scope="module")
def running(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Running]:
    folder = tmp_path_factory.mktemp("shared")
    certificate, key = certificate_in(folder)
    options = ["--port", "0", "--data", str(folder / "data"), "--token"]
    command = [sys.executable, "-m", "statwalk.cli", "serve", *options]
    command += ["--tls-cert", str(certificate), "--tls-key", str(key)]
    environment = os.environ | {"COLUMNS": "200", "PYTHONUNBUFFERED": "1"}
    with (
        (folder / "log").open("w") as log,
        subprocess.Popen(command, stdout=subprocess.PIPE, stderr=log, text=True, env=environment) as process,
    ):
        assert process.stdout is not None
        link = process.stdout.readline().split("https://")[1].split()[0]
        address, _, token = link.partition("/?token=")
        trust = ssl.create_default_context(cafile=str(certificate))
        yield Running(process, address, token, trust, folder / "data", folder / "log")
        process.kill()


def test_the_printed_link_opens_the_page(running: Running) -> None:
    with running.rest() as browser:
        assert browser.get("/").status_code == 401
        signed = browser.get(f"/?token={running.token}")
        assert (signed.status_code, signed.headers["location"]) == (303, "/")
        assert signed.headers["set-cookie"].startswith("__Host-statwalk_")
        assert "Secure" in signed.headers["set-cookie"]
        assert browser.get("/").status_code in (200, 503)  # 503: the page is not built here
        assert browser.get("/api/access").json()["role"] == "admin"


def socket_to(running: Running, path: str, headers: dict[str, str]) -> connect:
    """A viewer's connection in one thread: websockets' client of two threads now and then loses its request
    over TLS (3 of 4,000 on a busy computer, this one none of 12,000), probably since Python 3.11 lets two
    threads into one TLS connection at once.
    """
    options = {
        "additional_headers": headers,
        "compression": None,
        "open_timeout": PATIENCE,
        "max_queue": None,
    }
    return connect(f"wss://{running.address}{path}", ssl=running.trust, **options)


async def close_code_after_too_long_a_message(running: Running) -> int | None:
    headers = {"authorization": f"Bearer {running.token}"}
    async with socket_to(running, "/api/stages/main/stream", headers) as viewer:
        assert '"hello"' in str(await asyncio.wait_for(viewer.recv(), PATIENCE))
        await viewer.send("x" * (65 << 10))
        await asyncio.wait_for(viewer.wait_closed(), PATIENCE)
    return viewer.close_code


def test_the_stream_flows_over_tls(running: Running) -> None:
    assert asyncio.run(close_code_after_too_long_a_message(running)) == 1009


async def refused_stream(running: Running, query: str, headers: dict[str, str]) -> None:
    with pytest.raises(InvalidStatus, match="HTTP 40"):
        await socket_to(running, f"/api/stages/nowhere/stream{query}", headers)


def test_a_person_added_while_it_runs_gets_in(running: Running) -> None:
    token = AccessFile(running.data).add("ada", "view")
    with running.rest(headers={"authorization": f"Bearer {token}"}) as rest:
        assert rest.get("/api/access").json()["name"] == "ada"
        assert rest.post("/api/stages", json={}).status_code == 403


def test_what_is_in_an_address_is_not_in_the_log(running: Running) -> None:
    """The last test: it stops the server."""
    query = f"?token={GUESS}&token={running.token}"
    with running.rest() as rest:
        for path in ("/", "/api/stages", "/api/nothing", "/missing", "//x"):
            for method in ("GET", "POST", "BREW"):
                rest.request(method, path + query)
        rest.get("/api/stages" + query, headers={"host": "evil.example"})
        rest.get("/api/stages" + query, headers={"authorization": f"Bearer {running.token}"})
    for headers in ({}, {"authorization": f"Bearer {running.token}"}):
        asyncio.run(refused_stream(running, query, headers))
    running.process.send_signal(signal.SIGTERM)
    printed, _ = running.process.communicate(timeout=PATIENCE)
    assert running.process.returncode == 0
    said = printed + running.log.read_text()
    assert GUESS not in said
    assert running.token not in said
    assert "Traceback" not in said
