"""`statwalk serve`: the API and the viewer on this machine."""

from __future__ import annotations

import ipaddress
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape

from statwalk.files.scene import FILE_NAME as SCENE_FILE
from statwalk.services.library.load import shipped_machines, shipped_machines_folder, shipped_scenes
from statwalk.web.app import create_app
from statwalk.web.server import listening_socket, run
from statwalk.web.settings import Settings, data_folder

EXAMPLES = """Examples:

  statwalk serve

  statwalk serve --port 9000

  statwalk serve my-robot other-machine

  statwalk serve --watch my-robot

  statwalk serve tentacle

  statwalk serve playground
"""
console = Console(highlight=False)
errors = Console(stderr=True, highlight=False)


def _is_loopback(host: str) -> bool:
    """Returns whether only this computer can reach the address."""
    if host == "localhost":
        return True
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return False


def _fail(reason: str) -> typer.Exit:
    errors.print(f"[bold red]statwalk serve:[/] {escape(reason)}", soft_wrap=True)
    return typer.Exit(2)


def _folder(named: Path) -> Path:
    """The folder itself, or that of the shipped machine of this name."""
    is_shipped = not named.is_dir() and str(named) in shipped_machines()
    return shipped_machines_folder() / named if is_shipped else named


def serve(
    folders: Annotated[
        list[Path] | None,
        typer.Argument(
            help="Machine or scene folders to add, or shipped ones by name; the page opens on the first."
        ),
    ] = None,
    port: Annotated[int, typer.Option(help="TCP port; 0 takes a free one.", min=0, max=65535)] = 8000,
    data: Annotated[
        Path | None,
        typer.Option(help="The folder that keeps uploads; by default your data folder.", show_default=False),
    ] = None,
    watch: Annotated[
        bool, typer.Option(help="Play a machine.yaml on all stages as soon as you save it.")
    ] = False,
    host: Annotated[str, typer.Option(help="A loopback address; others are refused.")] = "127.0.0.1",
) -> None:
    """Serves the API and the viewer on this computer, until you press Ctrl+C."""
    if not _is_loopback(host):
        raise _fail(
            f"other computers can reach {host}, and the server asks for no password. Use 127.0.0.1, ::1 or "
            "localhost."
        )
    try:
        listener = listening_socket("127.0.0.1" if host == "localhost" else host, port)
    except OSError as error:
        raise _fail(
            f"cannot listen on {host} port {port}: {error.strerror}. Use another port: --port "
            f"{port + 1 if port < 65535 else 8000}"
        ) from None
    first = folders[0] if folders else None
    own = tuple(
        _folder(named) for named in folders or () if named.is_dir() or str(named) not in shipped_scenes()
    )
    scene = first.name if first and (_folder(first) not in own or (first / SCENE_FILE).is_file()) else ""
    app = create_app(Settings(folders=own, data=data or data_folder(), scene=scene, watch=watch))
    name = f"[{host}]" if ":" in host else host
    address = escape(f"http://{name}:{listener.getsockname()[1]}/")
    console.print(f"statwalk: [bold]{address}[/]   (Ctrl+C stops it)", soft_wrap=True)
    run(app, listener)
