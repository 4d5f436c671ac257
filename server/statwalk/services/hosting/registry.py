"""The stages that the server holds, by id."""

from __future__ import annotations

import secrets
import threading
import time
from collections.abc import Callable, Sequence
from contextlib import suppress

from statwalk.errors import BusyError, LimitError, StorageError, UnknownNameError
from statwalk.services.cancel import NEVER, CancelToken
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.apply_commands import check_room
from statwalk.services.hosting.commands import StageSetup
from statwalk.services.hosting.machine_versions import MachineVersions
from statwalk.services.hosting.pacing import Pacing
from statwalk.services.hosting.patience import patience, replaceable
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.hosting.stage_services import EncodeFact, MeasureTicks
from statwalk.services.hosting.store.committer import Statement
from statwalk.services.hosting.store.records import MAIN, StageIdentity
from statwalk.services.hosting.store.store import Store
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.limits import Limits
from statwalk.services.threads import Now
from statwalk.services.work.job import DoJob, do_here
from statwalk.stage.stage import Stage

UNCLAIMED_SHARE = 0.5
"""the part of all stages that may be unclaimed forks"""


def random_id() -> str:
    """Returns an id that no other stage has."""
    return secrets.token_hex(4)


class Registry:
    """Opens, finds and closes stages; `wake` has the ticker look at the clocks, `new_id` names a stage.
    Thread-safe.
    """

    def __init__(
        self,
        catalogue: Catalogue,
        encode_fact: EncodeFact,
        limits: Limits,
        wake: Callable[[], None] = lambda: None,
        store: Store | None = None,
        now: Now = time.perf_counter,
        new_id: Callable[[], str] = random_id,
    ) -> None:
        self.store, self.now, self.new_id = store, now, new_id
        self.catalogue, self.encode_fact, self.limits, self.wake = catalogue, encode_fact, limits, wake
        self.measure_ticks: MeasureTicks = lambda _late, _lost: None
        self.work: DoJob = do_here
        """does what takes long: verifying, measuring, computing many ticks of the past"""
        self.pacing = Pacing(limits.tick_share)
        self.lock = threading.Lock()
        self.stages: dict[str, StageHost] = {}
        self.left: dict[str, str] = {}
        """why stages did not come back when the server started, by id; their records are kept"""
        self.damage: list[str] = []
        """what is damaged beside stages: kept answers to requests, versions of machines"""
        self.versions = MachineVersions(catalogue, self.all, store)

    def all(self) -> list[StageHost]:
        """Returns the hosts of all stages."""
        return list(self.stages.values())

    def is_open(self, stage_id: str) -> bool:
        """Returns whether a stage has this id."""
        return stage_id in self.stages

    def find(self, stage_id: str) -> StageHost:
        """Returns the host of the stage with this id.

        :raises UnknownNameError: when no stage has this id.
        """
        host = self.stages.get(stage_id)
        if host is None:
            raise UnknownNameError("stage", stage_id, self.stages, self.left.get(stage_id, ""))
        if host.is_unclaimed:
            host.is_unclaimed = False
            self.wake()
        return host

    def hold(self, host: StageHost, also: Sequence[Statement] = ()) -> StageHost:
        """Adds a stage, keeps it and `also` in one commit, and returns its host. If the server is full, the
        stage takes the place of a replaceable one.

        :raises LimitError: when the server holds the most stages that it may.
        :raises StorageError: when the disk refuses to keep the stage.
        """
        self._check_unclaimed(host)  # before another stage goes for it
        self._make_room()
        self._add(host)
        try:
            self._keep(host, also)
        except StorageError:
            self._remove(host.id)
            raise
        self.wake()
        return host

    def _make_room(self) -> None:
        if len(self.stages) >= self.limits.stages:
            replaced = replaceable(self.all(), self.limits, self.now())
            if replaced is not None:
                self._remove(replaced.id)

    def _check_unclaimed(self, host: StageHost) -> None:
        unclaimed = sum(stage.is_unclaimed for stage in self.all())
        if host.is_unclaimed and unclaimed >= self.limits.stages * UNCLAIMED_SHARE:
            raise LimitError(
                f"the server holds {unclaimed} forks that nobody uses, and no more; use one of them",
                limit="stages",
            )

    def _add(self, host: StageHost) -> None:
        with self.lock:
            self._check_unclaimed(host)
            if len(self.stages) >= self.limits.stages:
                raise LimitError(
                    f"the server holds {self.limits.stages} stages, and no more; delete one first",
                    limit="stages",
                )
            self.stages[host.id] = host

    def _keep(self, host: StageHost, also: Sequence[Statement]) -> None:
        if self.store:
            host.keep(self.store.stage(host.identity), also)
            self.store.flush()

    # --- the store

    def check_storage(self) -> None:
        """:raises StorageError: while the disk refuses to keep what changes."""
        if self.store:
            self.store.writer.check()

    def trouble(self) -> str:
        """Returns why the disk refuses to keep what changes; empty while it does not."""
        refusal = self.store.writer.trouble if self.store else None
        return str(refusal) if refusal else ""

    def flush(self) -> None:
        """Waits until everything so far is kept.

        :raises StorageError: when the disk refuses.
        """
        if self.store:
            self.store.flush()

    def save(self) -> None:
        """Keeps the playheads, clocks and new snapshots of all stages; skips stages that are busy, and does
        nothing while the disk is behind: what waits for it must not grow.
        """
        for host in self.all() if self.store and not self.store.writer.is_behind else ():
            with suppress(BusyError):
                host.save()

    def open_main(self, scene: str = "") -> StageHost:
        """Opens the stage that the page shows first: real time, with a scene or the default machine. Returns
        the stage that was kept, if it was opened with the same scene or machine.
        """
        if MAIN in self.stages:
            return self.stages[MAIN]
        opened = self.main_content(scene)
        if scene:
            return self.hold(self._with_scene(MAIN, StageSetup(scene=scene), opened))
        stage = Stage()
        if self.catalogue.default is not None:
            stage.add(self.catalogue.role(self.catalogue.default))
        identity = StageIdentity(MAIN, opened, stage.seed, stage.rate, "real", made=time.time())
        return self.hold(StageHost(identity, stage, self))

    def main_content(self, scene: str = "") -> str:
        """Returns in a word what `main` opens with."""
        return f"scene {scene}" if scene else f"machine {self.catalogue.default}"

    def open(self, setup: StageSetup, token: CancelToken = NEVER) -> StageHost:
        """Opens a stage with its actors.

        :raises UnknownNameError: when no scene or machine has the name.
        :raises LimitError: when the setup has too many actors, or the server too many stages.
        :raises CancelledError: when the token is cancelled before the stage is open.
        """
        host = self._with_scene(self.new_id(), setup, f"scene {setup.scene}" if setup.scene else "")
        host.handle(ask.Post(setup.actors, forks=False), token)
        token.check()
        return self.hold(host)

    def close(self, stage_id: str) -> None:
        """Closes a stage, and disconnects its viewers.

        :raises UnknownNameError: when no stage has this id.
        :raises StorageError: when the disk refuses; the stage is closed all the same.
        """
        self.find(stage_id)
        self._remove(stage_id)
        self.flush()

    def drop_idle(self, now: float) -> None:
        """Closes the stages without viewers that had no request for longer than their `patience`.

        `now`: seconds of `self.now`.
        """
        for host in self.all():
            if host.idle_for(now) > patience(host, self.limits, is_stored=self.store is not None):
                self._remove(host.id)

    def _remove(self, stage_id: str) -> None:
        with self.lock:
            host = self.stages.pop(stage_id, None)
        if host:
            host.look(ask.Close())
            if self.store:
                self.store.drop(stage_id)

    def _with_scene(self, stage_id: str, setup: StageSetup, opened: str = "") -> StageHost:
        """Returns a host of a new stage with the actors of the setup's scene, without the setup's own."""
        scene = self.catalogue.scene(setup.scene) if setup.scene else None
        stage = Stage(
            seed=(scene.seed if scene else 0) if setup.seed is None else setup.seed, rate=setup.rate
        )
        if scene:
            check_room(sum(line.count for _, line in scene.lines), self.limits.actors)
            scene.enter(stage)
        identity = StageIdentity(
            stage_id, opened, stage.seed, stage.rate, setup.clock, setup.keep_running, time.time()
        )
        return StageHost(identity, stage, self, setup.name)
