"""`statwalk access`: who may use a shared server, and in which role."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer
from rich.console import Console
from rich.markup import escape
from rich.table import Table

from statwalk.services.access.access_file import AccessFile
from statwalk.services.access.roles import AccessRole
from statwalk.web.settings import data_folder

EXAMPLES = """Examples:

  statwalk access add ada --role drive

  statwalk access list

  statwalk access revoke ada

A running server takes a change at once. `view` may look, `drive` also sends events and moves stages, `admin`
also uploads, edits and deletes.
"""
console = Console(highlight=False)


def access(
    action: Annotated[Literal["add", "list", "revoke"], typer.Argument(help="What to do.")],
    name: Annotated[str, typer.Argument(help="Whose access.", show_default=False)] = "",
    role: Annotated[AccessRole, typer.Option(help="What a new person may do.")] = "view",
    data: Annotated[
        Path | None, typer.Option(help="The server's data folder; by default yours.", show_default=False)
    ] = None,
) -> None:
    """Gives people access to a shared server, lists them, and takes the access back."""
    file = AccessFile(data or data_folder())
    if (action == "list") == bool(name):
        raise typer.BadParameter("list takes no name" if name else f"{action} takes a name")
    if action == "list":
        _print_people(file)
    elif action == "revoke":
        file.revoke(name)
        console.print(f"{escape(name)} has no access any more", soft_wrap=True)
    else:
        token = file.add(name, role)
        console.print(f"{escape(name)} has the role {role}. The token, which is shown only now:\n{token}")
        console.print("The link is the server's address and /?token= and the token.", soft_wrap=True)


def _print_people(file: AccessFile) -> None:
    table = Table("name", "role", box=None, pad_edge=False)
    for person in file.people():
        table.add_row(escape(person.name), person.role)
    console.print(table)
