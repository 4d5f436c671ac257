"""The settings of a server, and the largest size of a request's body."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from pathlib import Path

from statwalk.services.access.authenticator import Authenticator
from statwalk.services.limits import Limits
from statwalk.web.same_origin import OwnNames

PACKAGE = Path(__file__).resolve().parent.parent
LOOPBACK = OwnNames(("127.0.0.1", "localhost", "[::1]"))

LARGEST_BODY_BYTES = 256 << 10
LARGEST_UPLOAD_BYTES = 64 << 20
LARGEST_MESSAGE_BYTES = 64 << 10


def _page_folder() -> Path:
    """Returns the folder of the built viewer: in the wheel, or in the checkout of an editable install."""
    inside = PACKAGE / "static"
    return inside if inside.is_dir() else PACKAGE.parent.parent / "static" / "dist"


def data_folder() -> Path:
    """Returns the folder of the user's data (XDG Base Directory Specification): $XDG_DATA_HOME/statwalk, else
    ~/.local/share/statwalk.
    """
    home = os.environ.get("XDG_DATA_HOME", "")
    return (Path(home) if Path(home).is_absolute() else Path.home() / ".local" / "share") / "statwalk"


@dataclass(frozen=True)
class Settings:
    """The settings of a server.

    `folders`: machine folders besides the shipped ones; the first is the default machine. `names`: how
    clients call the server. `page`: the folder of the built viewer. `main_stage`: whether the server opens
    the stage that the page shows first. `kept`: the folder in which stages and edits are kept, and from which
    they come back when a server starts; one server at a time can use it. None: they end with the server.

    `data`: the folder for uploaded characters and the machines made from them; None: the server refuses
    uploads. `scene`: the scene that the page shows first; empty: the default machine. `watch`: whether stages
    play a machine file as soon as it is saved. `authenticator`: knows the tokens; None: the server asks for
    none. `proxied`: whether all clients come through a proxy, so that limits know them by their tokens.
    """

    folders: tuple[Path, ...] = ()
    names: OwnNames = LOOPBACK
    page: Path = field(default_factory=_page_folder)
    main_stage: bool = True
    data: Path | None = None
    scene: str = ""
    watch: bool = False
    kept: Path | None = None
    limits: Limits = field(default_factory=Limits)
    authenticator: Authenticator | None = None
    proxied: bool = False
