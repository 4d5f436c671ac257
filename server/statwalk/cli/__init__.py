"""The command `statwalk`: one file per verb; only the file of the verb that runs is imported."""

from __future__ import annotations

import ast
import os
import sys
from importlib import import_module
from importlib.metadata import version as installed_version
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape

from statwalk.errors import StatwalkError
from statwalk.maths.prepare import prepare, prepare_once

VERBS = (
    "serve",
    "play",
    "replay",
    "verify",
    "measure",
    "new",
    "pose",
    "convert",
    "deduce",
    "draw",
    "rig",
    "lod",
    "access",
    "top",
    "doctor",
    "backup",
    "restore",
)

WITHOUT_KERNELS = frozenset({"access", "doctor", "backup", "restore"})
"""verbs that run no compiled code"""


def command(verb: str | None) -> typer.Typer:
    """Returns the command with one verb, or (None) with the names and summaries of all verbs.

    The module of a verb holds a function with the verb's name, and its EXAMPLES.
    """
    app = typer.Typer(
        no_args_is_help=True,
        add_completion=False,
        pretty_exceptions_enable=False,
        rich_markup_mode="rich",
        invoke_without_command=True,
    )
    app.callback()(_about)  # with one verb and no callback, typer would drop the verb from the command line
    if verb:
        module = import_module(f"statwalk.cli.{verb}")
        app.command(verb, epilog=module.EXAMPLES)(getattr(module, verb))
    else:
        for name in VERBS:
            app.command(name, help=_summary(name))(lambda: None)
    return app


def _summary(verb: str) -> str:
    """Returns the docstring of a verb's function, without importing the verb's module."""
    module = ast.parse(Path(__file__).with_name(f"{verb}.py").read_text(encoding="utf-8"))
    functions = {node.name: node for node in module.body if isinstance(node, ast.FunctionDef)}
    return ast.get_docstring(functions[verb]) or ""


def _about(
    version: Annotated[
        bool, typer.Option("--version", is_eager=True, help="Print the version and exit.")
    ] = False,
) -> None:
    """Animates characters from state tables: proved, streamed to a browser, tested without one."""
    if version:
        Console(highlight=False).print(f"statwalk {installed_version('statwalk')}")
        raise typer.Exit


def main() -> None:
    """Runs the verb of the command line; an error that a user's input causes prints one line, status 2."""
    verb = sys.argv[1] if sys.argv[1:2] and sys.argv[1] in VERBS else None
    try:
        if "--help" in sys.argv:
            os.environ["STATWALK_COMPILED"] = "0"  # the import of a verb would compile what help never runs
        elif verb and verb not in WITHOUT_KERNELS:
            prepare() if verb == "serve" else prepare_once()
        command(verb)()
    except (StatwalkError, OSError) as error:
        Console(stderr=True, highlight=False).print(
            f"[bold red]statwalk:[/] {escape(str(error))}", soft_wrap=True
        )
        sys.exit(2)
