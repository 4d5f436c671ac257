"""What the catalogue knows of a machine."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from statwalk.files.machine_yaml.machine_file import MachineFile


@dataclass(frozen=True)
class Entry:
    """A machine folder; `character` is its character's name in the catalogue; `made`: the folder is in the
    data folder, made by this API.
    """

    name: str
    folder: Path
    file: MachineFile
    character: str
    made: bool = False
    scene: str = ""
    """the scene whose folder holds the machine; empty: none"""
