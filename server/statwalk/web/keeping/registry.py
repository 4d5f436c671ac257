"""The stages that the server holds, by id."""

from __future__ import annotations

import math
import secrets
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from statwalk.errors import StatwalkError
from statwalk.stage.stage import Actor, Stage
from statwalk.web.keeping.catalogue import Catalogue
from statwalk.web.keeping.editions import Editions
from statwalk.web.keeping.hosted import HostedStage
from statwalk.web.problem import Problem
from statwalk.web.schemas import Accepted, NewActor, NewEvent, NewParameter, NewStage
from statwalk.web.settings import Settings

MAIN = "main"
MANUAL_PATIENCE = 6
"""times as long an idle stage is kept where the client decides when time passes"""


class Registry:
    """Opens, finds, forks and closes stages. Safe to use from several threads."""

    def __init__(self, catalogue: Catalogue, settings: Settings, wake: Callable[[], None] = lambda: None) -> None:
        self.catalogue, self.settings, self.wake = catalogue, settings, wake
        self.lock = threading.Lock()
        self.stages: dict[str, HostedStage] = {}
        self.editions = Editions(catalogue, self.all)

    def all(self) -> list[HostedStage]:
        """Those that there are now."""
        return list(self.stages.values())

    def find(self, stage_id: str) -> HostedStage:
        """The stage of that id.

        :raises Problem: 404, if there is none.
        """
        hosted = self.stages.get(stage_id)
        if hosted is None:
            raise Problem(404, f"there is no stage {stage_id[:80]!r}", field="stage", known=self.stages)
        return hosted

    def hold(self, hosted: HostedStage) -> HostedStage:
        """Takes a stage in.

        :raises Problem: 409, if the server holds as many as it may.
        """
        with self.lock:
            if len(self.stages) >= self.settings.most_stages:
                raise Problem(409, f"the server holds {self.settings.most_stages} stages, which is the most it may; delete one")
            self.stages[hosted.id] = hosted
        self.wake()
        return hosted

    def open_main(self) -> HostedStage:
        """The stage the page opens on: real time, with the default machine."""
        if self.settings.scene:
            return self.hold(self.furnished(MAIN, NewStage(scene=self.settings.scene)))
        stage = Stage()
        if self.catalogue.default is not None:
            stage.add(self.catalogue.role(self.catalogue.default))
        return self.hold(HostedStage(MAIN, stage, "real", self.catalogue))

    def furnished(self, stage_id: str, new: NewStage) -> HostedStage:
        """A stage, with the actors of its scene.

        :raises Problem: 422 for an unknown scene, 409 if it has too many actors.
        """
        scene = self.catalogue.scene(new.scene) if new.scene else None
        stage = Stage(seed=(scene.seed if scene else 0) if new.seed is None else new.seed, rate=new.rate)
        if scene:
            self.check_room(sum(line.count for _, line in scene.lines))
            scene.enter(stage)
        return HostedStage(stage_id, stage, new.clock, self.catalogue)

    def check_room(self, actors: int) -> None:
        """
        :raises Problem: 409, if a stage may not have so many actors.
        """
        if actors > self.settings.most_actors:
            raise Problem(409, f"the stage has {self.settings.most_actors} actors, which is the most it may have")

    def close(self, stage_id: str) -> None:
        """Lets a stage go; its viewers are sent away.

        :raises Problem: 404, if there is none.
        """
        hosted = self.find(stage_id)
        with self.lock:
            self.stages.pop(stage_id, None)
        hosted.broadcast.end(4404, "the stage was deleted")

    def place(self, hosted: HostedStage, new: NewActor) -> Actor:
        """Adds an actor to a stage.

        :raises Problem: 422 for an unknown machine, 409 if the stage is full.
        """
        role = self.catalogue.role(new.machine, status=422)
        with hosted.turn() as stage:
            self.check_room(sum(len(cast.ids) for cast in stage.state.casts) + 1)
            if new.machine in stage.roles:
                role = stage.role(new.machine)  # the version that this stage plays
            return hosted.add(role, new.position, math.radians(new.heading_deg), new.name)

    def open(self, new: NewStage) -> HostedStage:
        """Opens a stage with its actors."""
        hosted = self.furnished(secrets.token_hex(4), new)
        for actor in new.actors:
            self.place(hosted, actor)
        return self.hold(hosted)

    def fork(self, hosted: HostedStage, tick: int | None = None) -> HostedStage:
        """A new stage that goes on from the playhead of `hosted`, or from a tick of its past, with the past but without the future."""
        with hosted.turn() as stage:
            branch = stage.fork() if tick is None or tick == stage.tick else hosted.copy()
        if tick is not None and tick != branch.tick:
            branch.seek(tick)
            branch = branch.fork()
        return self.hold(HostedStage(secrets.token_hex(4), branch, hosted.clock_kind, self.catalogue))

    @contextmanager
    def writing(self, hosted: HostedStage, looked_at: int | None) -> Iterator[HostedStage]:
        """The stage that an input belongs to, for one caller: the stage itself at its newest tick, a fork in its past, which stays.

        A fork that was made for a refused input goes again.
        """
        with hosted.turn() as stage:
            tick = stage.tick if looked_at is None else min(looked_at, stage.head)
            if tick == stage.tick == stage.head:
                yield hosted
                return
        branch = self.fork(hosted, tick)  # it may have far to go: the stage itself runs on meanwhile
        try:
            with branch.turn():
                yield branch
        except (StatwalkError, Problem):
            self.close(branch.id)
            raise

    def post(self, hosted: HostedStage, event: NewEvent, looked_at: int | None = None) -> Accepted:
        """Logs an event, in a fork if it belongs to the past."""
        with self.writing(hosted, looked_at) as target:
            return Accepted(tick=target.stage.tick, seq=target.post(event), stage=target.id)

    def set_parameter(self, hosted: HostedStage, new: NewParameter, looked_at: int | None = None) -> Accepted:
        """Logs a parameter's value, in a fork if it belongs to the past."""
        with self.writing(hosted, looked_at) as target:
            return Accepted(tick=target.stage.tick, seq=target.set_parameter(new), stage=target.id)

    def drop_idle(self) -> None:
        """Lets go of stages that nobody has watched or used for a while, longer where the clock is the client's; `main` stays."""
        now = time.monotonic()
        for hosted in self.all():
            patience = self.settings.idle_seconds * (MANUAL_PATIENCE if hosted.clock_kind == "manual" else 1)
            if now - hosted.touched > patience and hosted.id != MAIN and not hosted.broadcast.mailboxes:
                self.stages.pop(hosted.id, None)
