"""The role that each route needs: the one table.

A route that is missing needs `admin`, unless it is a GET of a file of the page; a test says what is missing.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

from starlette.routing import compile_path

from statwalk.services.access.roles import AccessRole

SOCKET = "WEBSOCKET"
NO_ROLE = ("GET /healthz", "GET /readyz")
"""answered without a token"""
VIEW = (
    "GET /api/access",
    "GET /api/characters",
    "GET /api/characters/{name}",
    "GET /api/characters/{name}/bones",
    "GET /api/characters/{name}/feet",
    "GET /api/characters/{name}/formats",
    "GET /api/characters/{name}/levels",
    "GET /api/characters/{name}/lod.glb",
    "GET /api/characters/{name}/mapping",
    "GET /api/characters/{name}/model.glb",
    "GET /api/characters/{name}/model.{suffix}",
    "GET /api/characters/{name}/path",
    "GET /api/characters/{name}/skeleton.svg",
    "GET /api/characters/{name}/twinning",
    "GET /api/losses",
    "GET /api/machines",
    "GET /api/machines/{name}",
    "GET /api/machines/{name}/export.zip",
    "GET /api/machines/{name}/feet",
    "GET /api/machines/{name}/measure",
    "GET /api/machines/{name}/verify",
    "GET /api/machines/{name}/versions",
    "GET /api/machines/{name}/versions/{number}",
    "GET /api/machines/{name}/versions/{number}/differences",
    "GET /api/openapi.json",
    "GET /api/scenes",
    "GET /api/schemas/machine.json",
    "GET /api/stages",
    "GET /api/stages/{stage_id}",
    "GET /api/stages/{stage_id}/actors",
    "GET /api/stages/{stage_id}/actors/{actor_id}",
    "GET /api/stages/{stage_id}/actors/{actor_id}/pose",
    "GET /api/stages/{stage_id}/actors/{actor_id}/skeleton.svg",
    "GET /api/stages/{stage_id}/actors/{actor_id}/why",
    "GET /api/stages/{stage_id}/actors/{actor_id}/whynot",
    "GET /api/stages/{stage_id}/differences",
    "GET /api/stages/{stage_id}/facts",
    "GET /api/stages/{stage_id}/frame.glb",
    "GET /api/stages/{stage_id}/history",
    "GET /api/stages/{stage_id}/log",
    "GET /api/stages/{stage_id}/recording.glb",
    "GET /api/stages/{stage_id}/viewers",
    # these compute an answer from their body, and change nothing
    "POST /api/characters/{name}/solve",
    "POST /api/curves",
    "POST /api/deduce",
    # events and parameters on the socket need `drive`: socket/inbox.py
    f"{SOCKET} /api/stages/{{stage_id}}/stream",
)
DRIVE = (
    "DELETE /api/stages/{stage_id}",
    "DELETE /api/stages/{stage_id}/actors/{actor_id}",
    "DELETE /api/stages/{stage_id}/actors/{actor_id}/travel",
    "DELETE /api/stages/{stage_id}/links/{link_id}",
    "GET /api/stages/{stage_id}/links",
    "PATCH /api/stages/{stage_id}",
    "POST /api/stages",
    "POST /api/stages/{stage_id}/actors",
    "POST /api/stages/{stage_id}/actors/{actor_id}/travel",
    "POST /api/stages/{stage_id}/events",
    "POST /api/stages/{stage_id}/fork",
    "POST /api/stages/{stage_id}/links",
    "POST /api/stages/{stage_id}/parameters",
    "POST /api/stages/{stage_id}/pause",
    "POST /api/stages/{stage_id}/seek",
    "POST /api/stages/{stage_id}/speed",
    "POST /api/stages/{stage_id}/step",
)
ADMIN = (
    "DELETE /api/characters/{name}",
    "DELETE /api/machines/{name}",
    "GET /api/machines/{name}/unused",
    "GET /metrics",
    "PATCH /api/machines/{name}",
    "PATCH /api/machines/{name}/cells",
    "PATCH /api/machines/{name}/expressions",
    "POST /api/characters/{name}/clips",
    "POST /api/characters/{name}/lod",
    "POST /api/characters/{name}/rig",
    "POST /api/machines",
    "POST /api/machines/{name}/redo",
    "POST /api/machines/{name}/rename",
    "POST /api/machines/{name}/undo",
    "POST /api/machines/{name}/versions/{number}/restore",
    "PUT /api/characters/{name}",
    "PUT /api/machines/{name}",
    "PUT /api/machines/{name}/import.zip",
)
NEEDED_ROLES: Mapping[str, AccessRole | None] = MappingProxyType(
    dict.fromkeys(NO_ROLE)
    | dict.fromkeys(VIEW, "view")
    | dict.fromkeys(DRIVE, "drive")
    | dict.fromkeys(ADMIN, "admin")
)
BEYOND_A_LINK = frozenset(
    {
        "DELETE /api/stages/{stage_id}",
        "DELETE /api/stages/{stage_id}/links/{link_id}",
        "GET /api/stages/{stage_id}/differences",
        "GET /api/stages/{stage_id}/links",
        "PATCH /api/stages/{stage_id}",
        "POST /api/stages/{stage_id}/fork",
        "POST /api/stages/{stage_id}/links",
    }
)
"""what a link to a stage does not give of this stage"""
WITH_A_LINK = frozenset(
    {
        "GET /api/access",
        "GET /api/characters/{name}",
        "GET /api/characters/{name}/feet",
        "GET /api/characters/{name}/formats",
        "GET /api/characters/{name}/levels",
        "GET /api/characters/{name}/lod.glb",
        "GET /api/characters/{name}/model.glb",
        "GET /api/characters/{name}/model.{suffix}",
        "GET /api/machines/{name}",
        "GET /api/machines/{name}/export.zip",
        "GET /api/machines/{name}/feet",
        "GET /api/machines/{name}/verify",
        "GET /api/machines/{name}/versions",
        "GET /api/machines/{name}/versions/{number}",
        "GET /api/machines/{name}/versions/{number}/differences",
    }
)
"""what it gives besides its stage; the routes with a name only for what plays on the stage"""
_ROWS = [(row, *row.split(" ", 1)) for row in NEEDED_ROLES]
_COMPILED = [(row, method, compile_path(path)[0]) for row, method, path in _ROWS]


class Need(NamedTuple):
    """What a request needs: a `role` (None: not even a token); `stage` of its path, if it names one."""

    role: AccessRole | None
    stage: str | None
    is_in_a_link: bool

    def is_met_by(self, stage: str | None) -> bool:
        """Returns whether a link to this stage (None: a grant for all stages) reaches so far."""
        return stage is None or (self.is_in_a_link and self.stage in (None, stage))


def need_of(method: str, path: str) -> Need:
    """Returns what a request needs; `method` is `WEBSOCKET` for a socket."""
    method = "GET" if method == "HEAD" else method
    for row, row_method, pattern in _COMPILED:
        if method == row_method and (match := pattern.match(path)):
            stage = match.groupdict().get("stage_id")
            linked = row in WITH_A_LINK or (stage is not None and row not in BEYOND_A_LINK)
            return Need(NEEDED_ROLES[row], stage, linked)
    is_file = method == "GET" and not path.startswith("/api/")
    return Need("view" if is_file else "admin", None, is_file)
