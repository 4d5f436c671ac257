"""What the server is told when it starts, and the limits it keeps."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from pathlib import Path

PACKAGE = Path(__file__).resolve().parent.parent
LOOPBACK_HOSTS = ("127.0.0.1", "localhost", "[::1]")

LARGEST_BODY_BYTES = 256 << 10
LARGEST_UPLOAD_BYTES = 64 << 20
MOST_UPLOADS = 200
LARGEST_MESSAGE_BYTES = 64 << 10
MOST_STAGES = 64
MOST_ACTORS = 2_000
MOST_TICKS = 36_000
MOST_VIEWERS = 256
IDLE_SECONDS = 600.0


def page_folder() -> Path:
    """Where the built viewer is: in the wheel, or in the checkout of an editable install."""
    inside = PACKAGE / "static"
    return inside if inside.is_dir() else PACKAGE.parent.parent / "static" / "dist"


def data_folder() -> Path:
    """Where a user's data are kept (XDG Base Directory Specification): $XDG_DATA_HOME/statwalk, else ~/.local/share/statwalk."""
    given = os.environ.get("XDG_DATA_HOME", "")
    return (Path(given) if Path(given).is_absolute() else Path.home() / ".local" / "share") / "statwalk"


@dataclass(frozen=True)
class Settings:
    """`folders`: machine folders beside the shipped ones, the first is the default; `hosts`: names this server answers to.

    `data`: the folder that keeps uploaded characters and the machines made of them; without one nothing can be uploaded.

    `scene`: the one that the page opens on. `watch`: a machine file that is saved counts at once.
    """

    folders: tuple[Path, ...] = ()
    hosts: tuple[str, ...] = LOOPBACK_HOSTS
    page: Path = field(default_factory=page_folder)
    main_stage: bool = True
    data: Path | None = None
    scene: str = ""
    watch: bool = False
    most_stages: int = MOST_STAGES
    most_actors: int = MOST_ACTORS
    idle_seconds: float = IDLE_SECONDS
