"""The stages that the server holds, by id."""

from __future__ import annotations

import secrets
import threading
from collections.abc import Callable

from statwalk.errors import LimitError, UnknownNameError
from statwalk.services.cancel import NEVER, CancelToken
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.apply_commands import check_room
from statwalk.services.hosting.commands import StageSetup
from statwalk.services.hosting.live_stage import EncodeFact
from statwalk.services.hosting.machine_versions import MachineVersions
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.limits import Limits
from statwalk.stage.stage import Stage

MAIN = "main"
MANUAL_PATIENCE = 6
"""how many times longer an idle stage is kept if its clock is manual"""
UNCLAIMED_PATIENCE = 0.1
"""the part of `idle_seconds` for which an unclaimed fork is kept"""
UNCLAIMED_SHARE = 0.5
"""the part of all stages that may be unclaimed forks"""


class Registry:
    """Opens, finds and closes stages; `wake` has the ticker look at the clocks. Thread-safe."""

    def __init__(
        self,
        catalogue: Catalogue,
        encode_fact: EncodeFact,
        limits: Limits,
        wake: Callable[[], None] = lambda: None,
    ) -> None:
        self.catalogue, self.encode_fact, self.limits, self.wake = catalogue, encode_fact, limits, wake
        self.lock = threading.Lock()
        self.stages: dict[str, StageHost] = {}
        self.versions = MachineVersions(catalogue, self.all)

    def all(self) -> list[StageHost]:
        """Returns the hosts of all stages."""
        return list(self.stages.values())

    def find(self, stage_id: str) -> StageHost:
        """Returns the host of the stage with this id.

        :raises UnknownNameError: when no stage has this id.
        """
        host = self.stages.get(stage_id)
        if host is None:
            raise UnknownNameError("stage", stage_id, self.stages)
        host.is_unclaimed = False
        return host

    def hold(self, host: StageHost) -> StageHost:
        """Adds a stage, and returns its host.

        :raises LimitError: when the server holds the most stages that it may.
        """
        with self.lock:
            unclaimed = sum(stage.is_unclaimed for stage in self.stages.values())
            if host.is_unclaimed and unclaimed >= self.limits.stages * UNCLAIMED_SHARE:
                raise LimitError(
                    f"the server holds {unclaimed} forks that nobody uses, and no more; use one of them"
                )
            if len(self.stages) >= self.limits.stages:
                raise LimitError(
                    f"the server holds {self.limits.stages} stages, and no more; delete one first"
                )
            self.stages[host.id] = host
        self.wake()
        return host

    def open_main(self, scene: str = "") -> StageHost:
        """Opens the stage that the page shows first: real time, with a scene or the default machine."""
        if scene:
            return self.hold(self._with_scene(MAIN, StageSetup(scene=scene)))
        stage = Stage()
        if self.catalogue.default is not None:
            stage.add(self.catalogue.role(self.catalogue.default))
        return self.hold(StageHost(MAIN, stage, "real", self))

    def open(self, setup: StageSetup, token: CancelToken = NEVER) -> StageHost:
        """Opens a stage with its actors.

        :raises UnknownNameError: when no scene or machine has the name.
        :raises LimitError: when the setup has too many actors, or the server too many stages.
        :raises CancelledError: when the token is cancelled before the stage is open.
        """
        host = self._with_scene(secrets.token_hex(4), setup)
        host.handle(ask.Post(setup.actors, forks=False), token)
        token.check()
        return self.hold(host)

    def close(self, stage_id: str) -> None:
        """Closes a stage, and disconnects its viewers.

        :raises UnknownNameError: when no stage has this id.
        """
        self.find(stage_id)
        self._remove(stage_id)

    def drop_idle(self, now: float) -> None:
        """Closes the stages without viewers that had no request for `idle_seconds`; `main` stays.

        `now`: seconds of the monotonic clock.

        A stage with a manual clock is kept `MANUAL_PATIENCE` times longer, an unclaimed fork only for
        `UNCLAIMED_PATIENCE` of the time.
        """
        for host in self.all():
            if host.idle_for(now) > self._patience(host) and host.id != MAIN:
                self._remove(host.id)

    def _patience(self, host: StageHost) -> float:
        if host.is_unclaimed:
            return self.limits.idle_seconds * UNCLAIMED_PATIENCE
        return self.limits.idle_seconds * (MANUAL_PATIENCE if host.clock_kind == "manual" else 1)

    def _remove(self, stage_id: str) -> None:
        with self.lock:
            host = self.stages.pop(stage_id, None)
        if host:
            host.handle(ask.Close())

    def _with_scene(self, stage_id: str, setup: StageSetup) -> StageHost:
        """Returns a host of a new stage with the actors of the setup's scene, without the setup's own."""
        scene = self.catalogue.scene(setup.scene) if setup.scene else None
        stage = Stage(
            seed=(scene.seed if scene else 0) if setup.seed is None else setup.seed, rate=setup.rate
        )
        if scene:
            check_room(sum(line.count for _, line in scene.lines), self.limits.actors)
            scene.enter(stage)
        return StageHost(stage_id, stage, setup.clock, self)
