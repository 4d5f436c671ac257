"""R-17: a bit of a kept model flips: it is served as it was, or not at all."""

from pathlib import Path
from random import Random
from typing import Any

import httpx
import pytest
import tiny_model
from statwalk.services.library.model_store import ModelStore
from statwalk.web.app import create_app
from statwalk.web.settings import Settings

pytestmark = pytest.mark.anyio
FLIPS, FLIPS_OF_CHECKED = 24, 4
MODEL = "/api/characters/tiny/model.glb"


@pytest.fixture
def anyio_backend() -> str:
    return "asyncio"


def client_of(folder: Path) -> httpx.AsyncClient:
    """A server that has read nothing yet."""
    app: Any = create_app(Settings(data=folder, main_stage=False))
    return httpx.AsyncClient(
        transport=httpx.ASGITransport(app, raise_app_exceptions=False), base_url="http://localhost"
    )


async def shown(folder: Path) -> tuple[int, bytes]:
    """The model as the server gives it, and how it poses it."""
    async with client_of(folder) as client:
        model = await client.get(MODEL)
        if model.status_code != 200:
            return model.status_code, b""
        made = await client.post("/api/stages", json={"clock": "manual", "actors": [{"machine": "tiny"}]})
        frame = await client.get(f"{made.headers['location']}/frame.glb") if made.is_success else made
        return frame.status_code, model.content + frame.content


@pytest.fixture
async def kept(tmp_path: Path) -> tuple[Path, bytes]:
    """A folder with a model and a machine, and what the server shows of them."""
    async with client_of(tmp_path) as client:
        upload = {"content": tiny_model.model(), "headers": {"content-type": "model/gltf-binary"}}
        (await client.put("/api/characters/tiny", **upload)).raise_for_status()
        machine = {"name": "tiny", "character": "tiny"}
        (await client.post("/api/machines", json=machine)).raise_for_status()
    status, data = await shown(tmp_path)
    assert status == 200
    return tmp_path, data


async def statuses(folder: Path, right: bytes, suffix: str, flips: int) -> tuple[set[int], int]:
    """The statuses after each flip of a bit, and how often something else was shown."""
    (path,) = (folder / "characters").glob(f"*{suffix}")
    whole, found, wrong = path.read_bytes(), set(), 0
    for seed in range(flips):
        chance, changed = Random(seed), bytearray(whole)
        changed[chance.randrange(len(whole))] ^= 1 << chance.randrange(8)
        path.write_bytes(changed)
        status, data = await shown(folder)
        found.add(status)
        wrong += status == 200 and data != right
        path.write_bytes(whole)
    return found, wrong


async def test_r17_a_damaged_model_is_not_served(kept: tuple[Path, bytes]) -> None:
    assert await statuses(*kept, ".glb", FLIPS) == ({503}, 0)


async def test_r17_a_damaged_checked_character_is_made_again(kept: tuple[Path, bytes]) -> None:
    assert await statuses(*kept, ".npz", FLIPS_OF_CHECKED) == ({200}, 0)


async def test_r17_a_server_that_trusts_its_files_is_found_out(
    kept: tuple[Path, bytes], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The control."""
    monkeypatch.setattr(ModelStore, "read_model", lambda store, sha256: store.model(sha256).read_bytes())
    _, wrong = await statuses(*kept, ".glb", FLIPS)
    assert wrong > 0
