"""Keeps one stage in the database: what it is, its log, the machine texts that it plays, its snapshots."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial

from statwalk.character.role import Role
from statwalk.services.hosting.commands import AddActor, RemoveActor
from statwalk.services.hosting.stage_messages import Post
from statwalk.services.hosting.store.database import SEALED, STAGES
from statwalk.services.hosting.store.kept_keys import KeptKeys
from statwalk.services.hosting.store.kept_log import KeptLog
from statwalk.services.hosting.store.records import (
    KeptBeginning,
    Note,
    StageIdentity,
    StageRecord,
    sealed,
    stage_row,
)
from statwalk.services.hosting.store.writer import Statement, Writer
from statwalk.services.library.role_reference import model_digest
from statwalk.stage.clock import Clock
from statwalk.stage.history.log import Log
from statwalk.stage.stage import Stage

COLUMNS = f"{SEALED[STAGES]}, digest"
INSERT = f"INSERT INTO stages ({COLUMNS}) VALUES ({', '.join('?' for _ in COLUMNS.split())})"  # noqa: S608 - our own names
NOTE = (
    "UPDATE stages SET tick = ?, head = ?, hash = ?, paused = ?, speed = ?, name = ?, digest = ? WHERE id = ?"
)
AT_ONCE = AddActor, RemoveActor
"""commands that change the state of the tick that is shown"""
SNAPSHOT_TICKS = 960
"""ticks between the snapshots on the disk: a stage comes back by playing at most these and a second again.
16 times the ticks between those in memory: a power of two, so that the disk has all old ones too
"""


class KeptStage:
    """Writes what changes of one stage; the caller holds the stage. `text_of` gives the machine file's text
    of a role.
    """

    def __init__(self, identity: StageIdentity, writer: Writer, text_of: Callable[[Role], str]) -> None:
        self.identity, self._writer, self._text_of = identity, writer, text_of
        self.durable_head = 0
        """a crash leaves at least this tick: nothing that happened up to it can happen otherwise"""
        self.name = ""
        """what people call the stage"""
        self._noted: Note | None = None
        self._is_noting = False
        self._snapshots: set[int] = set()
        self._roles: set[str] = set()
        self._log: KeptLog | None = None
        self.keys = KeptKeys(identity.id, writer)

    def begin(self, stage: Stage, clock: Clock, also: Sequence[Statement] = ()) -> None:
        """Writes the whole stage, and other statements, in one commit; its log is kept from now on."""
        note, entries = self._note_of(stage, clock), stage.log
        first = Statement(INSERT, [stage_row(self.identity, note)])
        log = self._follow(stage)
        newest, self._noted = stage.newest, note
        self._writer.put(
            [
                first,
                *self._beginning(stage),
                *self._new_roles(stage),
                *log.begun(entries),
                *self._new_snapshots(stage),
                *also,
            ],
            lambda: log.written(newest),
        )

    def forget(self, stage: Stage, clock: Clock) -> None:
        """Forgets on the disk too what the stage has forgotten of its past, in one commit, with the playhead:
        the stage cannot come back before its first tick.
        """
        assert self._log is not None
        beginning, roles, log = self._beginning(stage), self._new_roles(stage), self._log.rewritten()
        self._writer.put(
            [*beginning, *roles, *log, *self._new_snapshots(stage), *self._new_note(stage, clock)]
        )

    def resume(self, stage: Stage, kept: StageRecord) -> None:
        """Goes on with a stage that was read from the database."""
        log = self._follow(stage, len(kept.lines), kept.chain)
        log.written(log.newest)
        self.durable_head, self.name = kept.note.head, kept.note.name
        self._snapshots, self._roles = set(kept.snapshots), set(kept.roles)
        self.keys.answers |= kept.keys

    def _follow(self, stage: Stage, place: int = 0, chain: bytes = b"") -> KeptLog:
        """Puts a log that is kept around the stage's log, of which `place` entries are in the database."""

        def wrapped(log: Log) -> KeptLog:
            return KeptLog(log, self.identity.id, self._writer, place, chain)

        self._log = stage.wrap_log(wrapped)
        return self._log

    @contextmanager
    def inputs(self, stage: Stage, clock: Clock, post: Post) -> Iterator[None]:
        """Puts all commands that are applied meanwhile into one commit, with the answer to their message."""
        with self.changes(
            stage, clock, at_once=any(isinstance(each, AT_ONCE) for each in post.commands)
        ) as rows:
            yield
            rows += self.keys.rows(post, stage.tick, stage.newest, self.identity.id)

    @contextmanager
    def changes(self, stage: Stage, clock: Clock, *, at_once: bool) -> Iterator[list[Statement]]:
        """Puts all commands that are applied meanwhile into one commit, with the texts of their machines and
        what the caller adds; and with the state that they lead to, if they change it `at_once`.
        """
        assert self._log is not None
        with self._log.gathered() as statements:
            try:
                yield statements
            finally:
                note = self._new_note(stage, clock) if at_once else []
                statements[:0] = [*self._new_roles(stage), *note]

    def note(self, stage: Stage, clock: Clock) -> None:
        """Writes how far the stage is, unless that is under way; `durable_head` follows."""
        if not self._is_noting:
            self._is_noting = True
            self._writer.put(self._new_note(stage, clock), partial(self._is_noted, stage.head))

    def _is_noted(self, head: int) -> None:
        self.durable_head, self._is_noting = max(self.durable_head, head), False

    def save(self, stage: Stage, clock: Clock) -> None:
        """Writes the playhead, the clock and new snapshots, if they changed."""
        if statements := [*self._new_snapshots(stage), *self._new_note(stage, clock)]:
            self._writer.put(statements)

    def _beginning(self, stage: Stage) -> list[Statement]:
        if not stage.first:
            return []
        row = sealed(self.identity.id, *KeptBeginning(stage.first, stage.forgotten_number))
        return [Statement("INSERT OR REPLACE INTO beginnings VALUES (?, ?, ?, ?)", [row])]

    def _note_of(self, stage: Stage, clock: Clock) -> Note:
        return Note(stage.tick, stage.head, stage.hash, clock.paused, clock.speed, self.name)

    def _new_note(self, stage: Stage, clock: Clock) -> list[Statement]:
        note = self._note_of(stage, clock)
        if note == self._noted:
            return []
        self._noted = note
        digest = stage_row(self.identity, note)[-1]
        return [Statement(NOTE, [(*note, digest, self.identity.id)])]

    def _new_roles(self, stage: Stage) -> list[Statement]:
        """The texts of roles that commands name for the first time; those of edits are in their commands,
        unless these are forgotten.
        """
        rows, forgotten = [], stage.forgotten_texts
        for key, role in stage.roles.items():
            if ("@" not in key or key in forgotten) and key not in self._roles:
                self._roles.add(key)
                text, model = forgotten.get(key) or self._text_of(role), model_digest(role)
                rows.append(sealed(self.identity.id, key, text, model))
        return [Statement("INSERT OR REPLACE INTO roles VALUES (?, ?, ?, ?, ?)", rows)] if rows else []

    def _new_snapshots(self, stage: Stage) -> list[Statement]:
        """New snapshots, and the removal of those that the stage itself no longer keeps."""
        kept = {
            tick: data
            for tick, data in stage.snapshots.data.items()
            if tick and (tick % SNAPSHOT_TICKS == 0 or tick == stage.first)
        }
        new, old = kept.keys() - self._snapshots, self._snapshots - kept.keys()
        self._snapshots = set(kept)
        rows = [sealed(self.identity.id, tick, kept[tick]) for tick in sorted(new)]
        gone = [(self.identity.id, tick) for tick in old]
        statements = [Statement("INSERT OR REPLACE INTO snapshots VALUES (?, ?, ?, ?)", rows)] if rows else []
        if gone:
            statements.append(Statement("DELETE FROM snapshots WHERE stage = ? AND tick = ?", gone))
        return statements
