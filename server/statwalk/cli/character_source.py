"""The argument of the verbs that take a character from wherever it is."""

from pathlib import Path
from typing import Annotated

import typer

CharacterSource = Annotated[
    Path,
    typer.Argument(
        help="A model or character file, a folder with a model or a machine, or a shipped machine."
    ),
]
"""what `character_from` reads"""
