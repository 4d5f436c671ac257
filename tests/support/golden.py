"""Golden sessions: recordings of one version of statwalk that later versions must play to the same states.

A folder for each version, tests/reliability/golden/0.1 and so on, holds

    sessions/NAME.jsonl     the logs, as GET …/log, `stage.dump()` and `statwalk replay` have them
    hashes.json             for each session its hash at every tenth tick and at its head; the hash of each
                            machine's model
    machines/               the texts of the machines as they were, and old models once the shipped ones
                            change
"""

import json
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path

from paths import ROOT
from random_sessions import MACHINE_FILE, character_at, folder_of
from statwalk.character.character import Character
from statwalk.character.role import Role
from statwalk.files.machine_yaml.capture_lines import with_captures
from statwalk.files.machine_yaml.machine_file import MachineFile
from statwalk.services.library.load import character_path, load_role, machine_folders, shipped_machines_folder
from statwalk.services.library.role_reference import model_digest
from statwalk.stage.history.engine import ENGINE
from statwalk.stage.history.log_codec import load
from statwalk.stage.replay import Roles, replay
from statwalk.stage.state.commands import Add

GOLDEN = ROOT / "tests" / "reliability" / "golden"
EVERY = 10
RECORD = "python tests/support/record_golden.py"
DRIFTED = """{session} of {version} is at tick {tick} in another state than it was.
Old sessions play differently now. If nobody wants that, mend the change. If it is wanted: raise ENGINE in
server/statwalk/stage/history/engine.py, say so in CHANGELOG.md, and record the present version again:
{record}. Keep the sessions of released versions: statwalk refuses them by their engine from then on."""
OTHER_MODEL = """{machine} has another model than {version} had. If {version} is not released, record it
again: {record}. If it is, keep the old model where its sessions find it:
git show v{version}.0:machines/{folder}/FILE > tests/reliability/golden/{version}/machines/{folder}/FILE"""


def hashes_of(lines: list[str], roles: Roles, every: int = EVERY) -> Iterator[tuple[int, str]]:
    """Plays a log; yields ticks and their hashes, the head's last."""
    head = load(lines).header["head"]
    stage = replay(lines, roles, until=0)
    while stage.tick < head:
        stage.step(min(every, head - stage.tick))
        yield stage.tick, stage.hash


@dataclass(frozen=True)
class Golden:
    """The sessions of one version."""

    folder: Path

    @cached_property
    def index(self) -> dict:
        return json.loads((self.folder / "hashes.json").read_text())

    @property
    def sessions(self) -> list[str]:
        return sorted(path.stem for path in (self.folder / "sessions").glob("*.jsonl"))

    def log(self, session: str) -> Path:
        return self.folder / "sessions" / f"{session}.jsonl"

    def lines(self, session: str) -> list[str]:
        return self.log(session).read_text(encoding="utf-8").splitlines()

    def is_of_this_engine(self, session: str) -> bool:
        return json.loads(self.lines(session)[0])["engine"] == ENGINE

    def role(self, key: str, text: str = "") -> Role:
        """The role of a key of a log, with the text and the model of this version."""
        return _role(self, key.partition("@")[0], text)

    def drift(self, session: str) -> str:
        """What is wrong if a session does not go as it went; empty if all is well."""
        lines, expected = self.lines(session), self.index["sessions"][session]
        for (tick, found), wanted in zip(hashes_of(lines, self.role), expected, strict=True):
            if found != wanted:
                changed = [machine for machine in _machines_of(lines) if self.has_another_model(machine)]
                return self._other_model(changed[0]) if changed else self._drifted(session, tick)
        return ""

    def has_another_model(self, machine: str) -> bool:
        return model_digest(self.role(machine)).hex() != self.index["models"][machine]

    def _drifted(self, session: str, tick: int) -> str:
        return DRIFTED.format(session=session, version=self.folder.name, tick=tick, record=RECORD)

    def _other_model(self, machine: str) -> str:
        folder = folder_of(machine).as_posix()
        return OTHER_MODEL.format(machine=machine, version=self.folder.name, folder=folder, record=RECORD)


@cache
def _role(golden: Golden, name: str, text: str) -> Role:
    kept = golden.folder / "machines" / folder_of(name) / MACHINE_FILE
    return load_role(
        machine_folders()[name], name, text or kept.read_text(encoding="utf-8"), golden_character(golden)
    )


@cache
def golden_character(golden: Golden):
    """Loads the character of a machine file: of the model that the version keeps, or of the shipped one."""

    def character_of(file: MachineFile, folder: Path) -> Character:
        path = character_path(file)
        kept = golden.folder / "machines" / path.relative_to(shipped_machines_folder())
        return with_captures(character_at(kept if kept.is_file() else path), file.captures, folder)

    return character_of


def _machines_of(lines: list[str]) -> list[str]:
    """The names of the machines that a log plays."""
    commands = [entry.command for entry in load(lines).entries]
    return sorted({command.role.partition("@")[0] for command in commands if isinstance(command, Add)})


def versions() -> list[Golden]:
    """All versions that have sessions."""
    return [Golden(folder) for folder in sorted(GOLDEN.iterdir()) if folder.is_dir()]
