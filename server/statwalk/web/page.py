"""Serves the viewer at `/`: a browser revalidates the page at every visit, and keeps its hashed assets."""

from __future__ import annotations

import os
from pathlib import Path

from fastapi import FastAPI
from starlette.responses import HTMLResponse, Response
from starlette.staticfiles import StaticFiles
from starlette.types import Scope

FOR_GOOD = "public, max-age=31536000, immutable"
NOT_BUILT = (
    "<!doctype html><meta charset=utf-8><title>statwalk</title><p>The viewer is not built. Run in "
    "static/: npm ci, then npm run build."
)


class Page(StaticFiles):
    """Static files with the cache headers of a Vite build."""

    def file_response(
        self,
        full_path: str | os.PathLike[str],
        stat_result: os.stat_result,
        scope: Scope,
        status_code: int = 200,
    ) -> Response:
        """Returns a file; the names in assets/ hold a hash of the content, so the browser keeps
        them for ever.
        """
        response = super().file_response(full_path, stat_result, scope, status_code)
        response.headers["Cache-Control"] = (
            FOR_GOOD if Path(full_path).parent.name == "assets" else "no-cache"
        )
        return response


def install(app: FastAPI, folder: Path) -> None:
    """Mounts the built viewer, or a page that says how to build it."""
    if (folder / "index.html").is_file():
        app.mount("/", Page(directory=folder, html=True), name="page")
        return

    @app.get("/", include_in_schema=False)
    def not_built() -> HTMLResponse:
        return HTMLResponse(NOT_BUILT, status_code=503)
