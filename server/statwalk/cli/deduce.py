"""`statwalk deduce`: what follows from the known values of a file, by the twelve rules."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer
from rich.console import Console
from rich.markup import escape
from rich.table import Table

from statwalk.errors import TextError
from statwalk.files.deduce_yaml import ANGLES, read_deduce
from statwalk.files.yaml.yaml_text import read_text

EXAMPLES = """Examples:

  statwalk deduce arm.yaml

  A file: bones (or `bones: mammal`), and what is known of them:

    bones: {hip: {length: 5, direction: [0, -1, 0]}, leg: {parent: hip, length: 4, direction: [0, -1, 0]}}

    known: {hip: {SP: [0, 0, 0]}, leg: {EP: [0, -8, 0], bend: [0, 0, 1]}}
"""
console = Console(highlight=False)


def deduce(
    file: Annotated[Path, typer.Argument(help="A file with bones and what is known of them.")],
) -> None:
    """Finds angles, matrices and points of bones from known ones (inverse kinematics by rules)."""
    answer = read_deduce(read_text(file, TextError), str(file)).answer()
    table = Table("bone", "quantity", "value", "source", box=None)
    for bone, values in answer.values.items():
        for quantity, known in values.items():
            name = ANGLES if quantity == "RA" else quantity
            value = np.degrees(known.value) if quantity == "RA" else known.value
            table.add_row(escape(bone), name, escape(_text(value)), known.source)
    console.print(table)
    for name, variable in answer.variables.items():
        console.print(escape(f"{name} = {_text(variable.value)}  ({variable.source})"), soft_wrap=True)
    if answer.unknown:
        names = ", ".join(f"{bone}.{quantity}" for bone, quantity in answer.unknown)
        console.print(f"[yellow]unknown:[/] {escape(names)}", soft_wrap=True)


def _text(value: Any) -> str:
    return " ".join(f"{number:.6g}" for number in np.ravel(np.round(value, 9) + 0.0))
