"""`statwalk serve`: the API and the viewer on this machine."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape

from statwalk.cli.exposure import Exposure
from statwalk.errors import ConflictError, ContentError, StorageError
from statwalk.files.scene import FILE_NAME as SCENE_FILE
from statwalk.services.access.access_file import AccessFile
from statwalk.services.library.load import shipped_machines, shipped_machines_folder
from statwalk.services.library.load_scene import shipped_scenes
from statwalk.services.limits import chosen
from statwalk.web.app import create_app
from statwalk.web.log_format import LogKind, set_up
from statwalk.web.server import listening_socket, run
from statwalk.web.settings import Settings, data_folder

EXAMPLES = """Examples:

  statwalk serve

  statwalk serve --port 9000

  statwalk serve my-robot other-machine

  statwalk serve --watch my-robot

  statwalk serve --log json --limit requests=100

  statwalk serve tentacle

  statwalk serve playground

  statwalk serve --token
"""
console = Console(highlight=False)
errors = Console(stderr=True, highlight=False)


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
    log: Annotated[
        LogKind, typer.Option(help="The form of the log on stderr; json also has a line for each request.")
    ] = LogKind.PLAIN,
    limit: Annotated[
        list[str] | None, typer.Option(help="NAME=VALUE: another limit; docs/limits.md names them all.")
    ] = None,
    host: Annotated[
        str, typer.Option(help="Where to listen. Other computers need a token and TLS: docs/access.md.")
    ] = "127.0.0.1",
    token: Annotated[
        bool, typer.Option("--token", help="Ask for a token, new at each start; prints a link with it.")
    ] = False,
    tls_cert: Annotated[
        Path | None, typer.Option(help="The certificate for https (PEM).", show_default=False)
    ] = None,
    tls_key: Annotated[Path | None, typer.Option(help="Its private key (PEM).", show_default=False)] = None,
    behind_proxy: Annotated[
        bool, typer.Option("--behind-proxy", help="A proxy in front of the server does TLS.")
    ] = False,
    public_url: Annotated[
        str, typer.Option(help="The https:// address that clients use.", show_default=False)
    ] = "",
) -> None:
    """Serves the API and the viewer on this computer, until you press Ctrl+C."""
    data = data or data_folder()
    exposure, people = Exposure(host, token, tls_cert, tls_key, behind_proxy, public_url), AccessFile(data)
    try:
        exposure.check(people)
    except ContentError as error:
        raise _fail(str(error)) from None
    set_up(log)
    limits = chosen(limit or ())
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
    bound = listener.getsockname()[1]
    names, authenticator = exposure.names(bound), exposure.authenticator(people)
    settings = Settings(
        own,
        names,
        data=data,
        scene=scene,
        watch=watch,
        kept=data,
        limits=limits,
        authenticator=authenticator,
        proxied=behind_proxy,
    )
    try:
        app = create_app(settings)
    except (ConflictError, StorageError) as error:
        raise _fail(str(error)) from None
    address = exposure.address(bound, authenticator)
    console.print(f"statwalk: [bold]{escape(address)}[/]   (Ctrl+C stops it)", soft_wrap=True)
    run(app, listener, limits, exposure.tls)
