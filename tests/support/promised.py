"""What a store acknowledged, and whether a start finds all of it: each input once, and in order."""

from __future__ import annotations

import json
import sqlite3
from contextlib import closing
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

from statwalk.errors import StatwalkError
from statwalk.services.hosting.store.database import FILE_NAME, opened
from statwalk.services.hosting.store.read_records import KeptRecords
from statwalk.services.hosting.store.records import StageRecord
from traced import Answer


class Kept(NamedTuple):
    """What a start finds; `trouble`: why it cannot be read, or empty."""

    stages: dict[str, StageRecord]
    versions: dict[str, int]
    trouble: str = ""


@dataclass
class _Stage:
    inputs: list[int] = field(default_factory=list)
    refused: int = 0
    """inputs that the disk refused: each may be there, and once only"""
    keys: dict[str, int] = field(default_factory=dict)
    tick: int = 0


@dataclass
class Promised:
    """What was acknowledged so far."""

    stages: dict[str, _Stage] = field(default_factory=dict)
    versions: dict[str, int] = field(default_factory=dict)
    gone: set[str] = field(default_factory=set)
    inputs: int = 0

    def add(self, answer: Answer) -> None:
        """Adds an answer; what the disk refused is no promise."""
        if "disk" in answer:
            return
        if "machine" in answer:
            self.versions[answer["machine"]] = answer["version"]
            return
        name, is_now = answer["stage"], answer.get("is")
        if is_now == "going":  # from now on it may be there or not
            self.stages.pop(name, None)
        elif is_now == "gone":
            self.gone.add(name)
        else:
            stage = self.stages.setdefault(name, _Stage())
            stage.tick = answer.get("tick", stage.tick)
            stage.refused += "refused" in answer
            if "input" in answer:
                self.inputs += 1
                stage.inputs.append(answer["input"])
                if answer["key"]:
                    stage.keys[answer["key"]] = answer["input"]

    def broken(self, kept: Kept) -> str:
        """Returns which promise a start breaks, or nothing."""
        if kept.trouble:
            return kept.trouble
        if back := self.gone & kept.stages.keys():
            return f"the deleted stages {sorted(back)} are back"
        for machine, version in self.versions.items():
            if kept.versions.get(machine, 0) < version:
                return f"version {version} of {machine} is missing"
        for name, stage in self.stages.items():
            record = kept.stages.get(name)
            if problem := "is missing" if record is None else _broken(stage, record):
                return f"stage {name}: {problem}"
        return ""


def _broken(stage: _Stage, record: StageRecord) -> str:
    found = [number for line in record.lines if (number := _press(line))]
    if lost := set(stage.inputs) - set(found):
        return f"{len(lost)} of {len(stage.inputs)} inputs are missing"
    if any(second <= first for first, second in pairwise(found)):
        return "its inputs are not there once and in order"
    if len(found) > len(stage.inputs) + stage.refused + 1:  # the one whose answer was on its way
        return "it has inputs that nobody sent"
    if record.note.tick < stage.tick:
        return f"it is at tick {record.note.tick}, and not at {stage.tick}"
    known = record.keys
    if any(key not in known or known[key].seq != number for key, number in stage.keys.items()):
        return "the answer to a key is missing"
    return ""


@lru_cache(maxsize=200_000)
def _press(line: str) -> int:
    """The number of an input; 0 for another entry."""
    entry = json.loads(line)
    return int(entry["number"]) if entry["kind"] == "press" else 0


def found_in(folder: Path) -> Kept:
    """Opens a data folder as a start does, examines it, and reads all of it."""
    records = KeptRecords(folder / FILE_NAME)
    try:
        with closing(opened(records.path)):
            return _read(records)
    except (StatwalkError, OSError) as error:
        return Kept({}, {}, str(error))
    except sqlite3.Error as error:
        return Kept({}, {}, f"it cannot be opened: {error}")


def _read(records: KeptRecords) -> Kept:
    damage = "; ".join(records.damage()[:3])
    stages = {name: records.record(name) for name in records.ids()}
    versions = {machine: all_[-1].number for machine, all_ in records.versions().items()}
    return Kept(stages, versions, damage)
