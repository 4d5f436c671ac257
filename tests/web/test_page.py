"""The page, its headers, and what is said where it is not built."""

from pathlib import Path
from typing import Any

import httpx
import pytest
from statwalk.web.app import create_app
from statwalk.web.settings import Settings

pytestmark = pytest.mark.anyio


@pytest.fixture
def dist(tmp_path: Path) -> Path:
    (tmp_path / "assets").mkdir()
    (tmp_path / "index.html").write_text("<!doctype html><title>statwalk</title>")
    (tmp_path / "assets" / "index-1a2b3c.js").write_text("export {};")
    (tmp_path.parent / "secret.txt").write_text("secret")
    return tmp_path


async def get(page: Path, path: str) -> httpx.Response:
    app: Any = create_app(Settings(page=page, main_stage=False))
    async with httpx.AsyncClient(transport=httpx.ASGITransport(app), base_url="http://localhost") as client:
        return await client.get(path)


async def test_the_page_is_asked_for_anew(dist: Path) -> None:
    page = await get(dist, "/")
    assert page.headers["cache-control"] == "no-cache"
    assert "script-src 'self'" in page.headers["content-security-policy"]


async def test_its_assets_are_kept(dist: Path) -> None:
    asset = await get(dist, "/assets/index-1a2b3c.js")
    assert "immutable" in asset.headers["cache-control"]
    assert asset.headers["content-type"].startswith("text/javascript")


@pytest.mark.parametrize(
    "path", ["/secret.txt", "/%2e%2e/secret.txt", "/..%2fsecret.txt", "/assets/%2e%2e/%2e%2e/secret.txt"]
)
async def test_nothing_beside_the_page_is_served(dist: Path, path: str) -> None:
    assert (await get(dist, path)).status_code == 404


async def test_a_page_that_is_not_built_says_so(tmp_path: Path) -> None:
    page = await get(tmp_path, "/")
    assert page.status_code == 503
    assert "npm run build" in page.text
