"""Serves the viewer at `/`: a browser revalidates the page at every visit, and keeps its hashed assets."""

from __future__ import annotations

import os
from pathlib import Path

from fastapi import FastAPI
from starlette.exceptions import HTTPException
from starlette.responses import HTMLResponse, Response
from starlette.staticfiles import StaticFiles
from starlette.types import Scope

FOR_GOOD = "public, max-age=31536000, immutable"
ALLOW = {"Allow": "GET, HEAD, OPTIONS"}
NOT_BUILT = (
    "<!doctype html><meta charset=utf-8><title>statwalk</title><p>The viewer is not built. Run in "
    "static/: npm ci, then npm run build."
)


class Page(StaticFiles):
    """Static files with the cache headers of a Vite build."""

    async def get_response(self, path: str, scope: Scope) -> Response:
        """Returns the answer for a path; another method than GET is a 404 where no file is, else a 405.

        :raises HTTPException: 404 or 405.
        """
        response = await super().get_response(path, {**scope, "method": "GET"})
        if scope["method"] == "GET":  # the guard passes HEAD as GET
            return response
        if scope["method"] == "OPTIONS":
            return Response(status_code=204, headers=ALLOW)
        raise HTTPException(405, f"this address answers to {ALLOW['Allow']}", headers=ALLOW)

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
