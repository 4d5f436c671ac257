"""The command `statwalk`: one file per verb, imported only when it is asked for."""

from __future__ import annotations

import sys
from importlib import import_module
from importlib.metadata import version as installed_version
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape

from statwalk.errors import StatwalkError

VERBS = ("serve", "play", "verify", "new", "pose")


def command(wanted: list[str]) -> typer.Typer:
    """The command with the verbs `wanted`; each module has a function of its verb's name and its EXAMPLES."""
    app = typer.Typer(
        no_args_is_help=True,
        add_completion=False,
        pretty_exceptions_enable=False,
        rich_markup_mode="rich",
        invoke_without_command=True,
    )
    app.callback()(about)  # keeps the verb a word of its own where only one is registered
    for verb in wanted:
        module = import_module(f"statwalk.cli.{verb}")
        app.command(verb, epilog=module.EXAMPLES)(getattr(module, verb))
    return app


def about(version: Annotated[bool, typer.Option("--version", is_eager=True, help="Print the version and exit.")] = False) -> None:
    """Animates characters from state tables: proved, streamed to a browser, tested without one."""
    if version:
        Console(highlight=False).print(f"statwalk {installed_version('statwalk')}")
        raise typer.Exit


def main() -> None:
    """Runs the verb that was asked for; what a user's input can cause ends with one line and status 2."""
    asked = sys.argv[1:2]
    try:
        command(asked if asked and asked[0] in VERBS else list(VERBS))()
    except (StatwalkError, OSError) as error:
        Console(stderr=True, highlight=False).print(f"[bold red]statwalk:[/] {escape(str(error))}", soft_wrap=True)
        sys.exit(2)
