"""The parts of the server that a stage uses."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Protocol

from statwalk.services.hosting.pacing import Pacing
from statwalk.services.hosting.stage_replies import Camera, Present, StageStatus
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.limits import Limits
from statwalk.services.threads import Now
from statwalk.services.work.job import DoJob
from statwalk.stage.state.frame import Action, Verdict

EncodeFact = Callable[[Action | Verdict | StageStatus | Present | Camera], bytes]
"""encodes an action, a verdict, a status, the viewers or a camera as a text message for viewers"""
MeasureTicks = Callable[[Sequence[float], int], None]
"""is told by how many seconds each tick of a real-time stage is late, and how many were left out"""


class StageServices(Protocol):
    """The catalogue, the limits, the clock and the store of a server."""

    catalogue: Catalogue
    limits: Limits
    encode_fact: EncodeFact
    measure_ticks: MeasureTicks
    pacing: Pacing
    now: Now
    work: DoJob
    """does what takes long"""
    new_id: Callable[[], str]
    """returns the id of a new stage"""
    wake: Callable[[], None]
    """has the ticker look at the clocks now"""

    def is_open(self, stage_id: str) -> bool:
        """Returns whether the server holds a stage with this id."""

    def trouble(self) -> str:
        """Returns why nothing can be kept now; empty while everything is kept."""

    def check_storage(self) -> None:
        """:raises StorageError: while the disk refuses to keep what changes."""

    def flush(self) -> None:
        """Waits until everything so far is kept; :raises StorageError: when the disk refuses."""
