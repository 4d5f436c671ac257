"""A machine that is made, copied, imported or renamed again with its Idempotency-Key is the same one."""

import io
import zipfile
from collections.abc import AsyncIterator
from pathlib import Path

import httpx
import pytest
from statwalk.services.library.made_keys import MadeKey, sign
from uploads import names, opened

pytestmark = pytest.mark.anyio
MACHINES = "/api/machines"
ZIPPED = (
    "character: elbow\ninitial: A\nstates: {A: {motion: bend, loop: true}}\ntable: |\n  state | GO\n  A | A\n"
)
KEY = {"Idempotency-Key": "one"}


@pytest.fixture
def anyio_backend() -> str:
    return "asyncio"


@pytest.fixture
async def client(tmp_path: Path) -> AsyncIterator[httpx.AsyncClient]:
    async with opened(tmp_path) as client:
        yield client


def packed() -> bytes:
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w") as archive:
        archive.writestr(zipfile.ZipInfo("machine.yaml"), ZIPPED)  # the same bytes each time
    return data.getvalue()


async def ask(client: httpx.AsyncClient, kind: str, headers: dict[str, str]) -> httpx.Response:
    match kind:
        case "make":
            return await client.post(MACHINES, json={"name": "mine"}, headers=headers)
        case "copy":
            return await client.post(MACHINES, json={"name": "mine", "copy_of": "elbow"}, headers=headers)
        case "import":
            zip_header = {"Content-Type": "application/zip"}
            path = f"{MACHINES}/mine/import.zip"
            return await client.put(path, content=packed(), headers=headers | zip_header)
    return await client.post(f"{MACHINES}/first/rename", json={"to": "mine"}, headers=headers)


@pytest.mark.parametrize("kind", ["make", "copy", "import", "rename"])
async def test_again_it_is_the_same_machine_also_after_a_start(
    client: httpx.AsyncClient, tmp_path: Path, kind: str
) -> None:
    await client.post(MACHINES, json={"name": "first"})
    first, again = [await ask(client, kind, KEY) for _ in range(2)]
    assert (first.is_success, again.status_code, again.json()) == (True, first.status_code, first.json())
    async with opened(tmp_path) as later:
        before = await names(later, "machines")
        assert (await ask(later, kind, KEY)).json()["name"] == "mine"
        assert await names(later, "machines") == before
    assert (await ask(client, kind, {})).status_code in (404, 409)  # the control: without a key


async def test_it_has_the_name_that_it_got_meanwhile(client: httpx.AsyncClient) -> None:
    await ask(client, "make", KEY)
    await client.post(f"{MACHINES}/mine/rename", json={"to": "yours"})
    again = await ask(client, "make", KEY)
    assert (again.json()["name"], again.headers["Location"]) == ("yours", f"{MACHINES}/yours")
    assert "mine" not in await names(client, "machines")


async def test_a_rename_that_came_to_nothing_is_made(client: httpx.AsyncClient, tmp_path: Path) -> None:
    """The server ended between the key and the rename."""
    await client.post(MACHINES, json={"name": "first"})
    sign(tmp_path / "machines" / "first", MadeKey.of("one", "rename", "first", "mine"))
    assert (await ask(client, "rename", KEY)).json()["name"] == "mine"


async def test_a_key_of_another_request_is_a_conflict(client: httpx.AsyncClient) -> None:
    await ask(client, "make", KEY)
    other = await client.post(MACHINES, json={"name": "other"}, headers=KEY)
    assert (other.status_code, other.json()["errors"][0]["field"]) == (409, "Idempotency-Key")
    assert "other" not in await names(client, "machines")
