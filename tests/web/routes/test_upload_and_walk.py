"""The issue's way over a real server: a robot is dropped, a machine made of it, and it walks; another stage
does not notice.
"""

import socket
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import httpx
import pytest
from paths import ASSETS, GLTF, MACHINES, needs_assets
from serving import PATIENCE, serving, wait_for
from statwalk.web.app import create_app
from statwalk.web.settings import Settings
from watcher import Watcher

SHARED = ["RobotExpressive", "Quaternius_PlatformerCharacter", "KayKit_Knight", "Quaternius_Fox"]
ANY = "KayKit_Knight" if ASSETS.is_dir() else "walker"


@pytest.fixture
def address(tmp_path: Path) -> Iterator[str]:
    with serving(create_app(Settings(data=tmp_path))) as address:
        yield address


@pytest.fixture
def rest(address: str) -> Iterator[httpx.Client]:
    with httpx.Client(base_url=f"http://{address}", timeout=PATIENCE) as rest:
        yield rest


def model_of(name: str) -> bytes:
    """The file of a model: a shared one, or, in a clone on its own, one that ships."""
    return (next(MACHINES.rglob(f"{name}.glb")) if name not in SHARED else GLTF / f"{name}.glb").read_bytes()


def dropped(rest: httpx.Client, name: str) -> str:
    """The path of a stage with the machine made of a model."""
    mine = f"my-{name}"
    rest.put(
        f"/api/characters/{mine}", content=model_of(name), headers={"content-type": "model/gltf-binary"}
    ).raise_for_status()
    rest.post("/api/machines", json={"name": mine, "character": mine}).raise_for_status()
    stage = rest.post("/api/stages", json={"clock": "manual", "actors": [{"machine": mine}]})
    return stage.raise_for_status().headers["Location"]


@needs_assets
@pytest.mark.parametrize("name", SHARED)
def test_a_dropped_character_walks(rest: httpx.Client, name: str) -> None:
    stage = dropped(rest, name)
    assert rest.get(stage).json()["actors"][0]["state"] == "STAT"
    rest.post(f"{stage}/events", json={"event": "FORWARD"}).raise_for_status()
    shown = rest.post(f"{stage}/step", json={"ticks": 1}).json()
    assert shown["actors"][0]["state"] == "WALK"


def test_the_stream_names_the_model_it_plays(address: str, rest: httpx.Client) -> None:
    with Watcher(address, dropped(rest, ANY)) as viewer:
        model = viewer.hello["casts"][0]["model"]
    assert rest.get(model).content == model_of(ANY)


def test_an_upload_that_ends_early_leaves_nothing(address: str, tmp_path: Path) -> None:
    host, port = address.split(":")
    with socket.create_connection((host, int(port))) as sender:
        head = (
            f"PUT /api/characters/x HTTP/1.1\r\nHost: {address}\r\nContent-Type: model/gltf-binary\r\n"
            "Content-Length: 1000\r\n\r\n"
        )
        sender.sendall(head.encode() + bytes(500))
        wait_for(lambda: list(tmp_path.glob("tmp/*/upload")))
    wait_for(lambda: not list(tmp_path.glob("tmp/*")))
    assert not list(tmp_path.glob("names/*"))


def test_another_stage_goes_on_meanwhile(address: str, rest: httpx.Client) -> None:
    with Watcher(address, "/api/stages/main") as viewer, ThreadPoolExecutor(1) as aside:
        first = viewer.frame().tick
        upload = aside.submit(dropped, rest, ANY)
        ticks = [first]
        while not upload.done():
            ticks.append(viewer.frame().tick)
        assert upload.result()
    assert ticks == sorted(set(ticks))
    assert len(ticks) > 5
