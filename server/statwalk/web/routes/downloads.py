"""A character in other file formats: GET /api/characters/{name}/formats and /model.bvh, /model.chunk …"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Annotated, Any

from fastapi import APIRouter, Depends, Query, Response

from statwalk.character.character import Character
from statwalk.files.file_format import FileFormat
from statwalk.files.model_formats import WRITTEN, format_of
from statwalk.files.zipped import zipped
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.convert import with_first
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import LongWorkToken, catalogue_of
from statwalk.web.errors import Problem
from statwalk.web.schemas.download import FormatView, LossView

router = APIRouter(prefix="/api/characters", tags=["characters"], route_class=BoundedRoute)
CatalogueDep = Annotated[Catalogue, Depends(catalogue_of)]
MOST_NAMES = 40
FORMATS = {suffix: format_of(Path(f"character{suffix}")) for suffix in WRITTEN}
ZIP = "application/zip"
"""of a format with several files"""
FILES: dict[int | str, dict[str, Any]] = {200: {"content": {row.media_type: {} for row in FORMATS.values()}}}


@router.get("/{name}/formats")
def list_formats(name: str, catalogue: CatalogueDep) -> list[FormatView]:
    """Lists the formats in which the character can be downloaded, and what each cannot hold of it."""
    character = catalogue.character(name)
    return [_view(name, character, row, suffix) for suffix, row in FORMATS.items()]


def _view(name: str, character: Character, row: FileFormat, suffix: str) -> FormatView:
    lost = [
        LossView(
            part=loss.part, count=len(loss.names), names=list(loss.names[:MOST_NAMES]), instead=loss.instead
        )
        for loss in row.losses(character)
    ]
    return FormatView(format=row.name, suffix=suffix, file=f"/api/characters/{name}/model{suffix}", lost=lost)


@router.get("/{name}/model.{suffix}", response_class=Response, responses=FILES)
def get_model_as(
    name: str,
    suffix: str,
    catalogue: CatalogueDep,
    token: LongWorkToken,
    clip: Annotated[str, Query(max_length=1_000)] = "",
) -> Response:
    """Returns the character as a file of another format, or as a zip if the format has several files; `clip`
    comes first, and is the only one where a format holds one.
    """
    character = with_first(catalogue.character(name), clip)
    row = FORMATS.get(f".{suffix}")
    if row is None:
        raise Problem(404, f"no format is called {suffix[:20]!r}", field="suffix", known=list(FORMATS))
    plain = re.sub(r"[^\w.-]+", "-", name, flags=re.ASCII)
    files = row.files(character, plain)
    token.check()
    is_zip = row.write_many is not None
    headers = {
        "Cache-Control": "no-cache",
        "Content-Disposition": f'attachment; filename="{plain}.{"zip" if is_zip else suffix}"',
    }
    data = zipped(files) if is_zip else next(iter(files.values()))
    return Response(data, media_type=ZIP if is_zip else row.media_type, headers=headers)
