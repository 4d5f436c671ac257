"""The stream of one viewer: its outbox on the server, which sends as web/socket/stream.py, and two pipes."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from simulated.network import Network, Pipe
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.publish.outbox import EncodedFrame, Outbox

if TYPE_CHECKING:
    from simulated.server import Server
    from simulated.viewers import Viewer


class Connection:
    """`unacknowledged`: the ticks of frames that were sent, as the checker counts them. `is_blocked`: the
    viewer reads nothing, and the buffers are full.
    """

    def __init__(self, network: Network, viewer: "Viewer") -> None:
        self.viewer, self.outbox = viewer, Outbox("pose")
        self.down, self.up = Pipe(network, viewer.name), Pipe(network, viewer.name)
        self.unacknowledged: list[int] = []
        self.is_over = self.is_blocked = False
        self.seeks = 0
        """how often the playhead of the stage was moved since it connected"""

    def serve(self, host: StageHost, server: "Server") -> None:
        self.host, self.server = host, server
        host.join(self.outbox, server)
        frame = host.handle(ask.Frame("pose"))
        self.outbox.put_frame(frame)
        self.pump()

    def pump(self) -> None:
        """Sends the facts, then the newest frame, if the viewer has credit."""
        outbox = self.outbox
        if self.is_over or not outbox.filled.is_set():
            return
        if outbox.closing is not None:
            self.end(outbox.closing[0])
            return
        if self.is_blocked:
            return
        outbox.filled.clear()
        for fact in outbox.take_texts():
            self.down.send(self.viewer.told, self, fact)
        if (frame := outbox.take_frame(self.server.registry.now())) is not None:
            self._send(frame)

    def _send(self, frame: EncodedFrame) -> None:
        self.unacknowledged.append(frame.tick)
        self.server.checker.sent(self, frame)
        self.down.send(self.viewer.shown, self, frame, self.seeks)

    def acknowledge(self, tick: int) -> None:
        """The viewer acknowledges a frame."""
        self.up.send(self._arrived, self._acknowledged, tick)

    def hang_up(self) -> None:
        """The viewer leaves."""
        self.down.is_cut = True
        self.server.process.after(0.0, self._left)

    def _arrived(self, act: Callable[..., None], *arguments: Any) -> None:
        self.server.process.after(0.0, act, *arguments)

    def _left(self) -> None:
        if not self.is_over:
            self.is_over = True
            self.server.left(self, self.host)

    def _acknowledged(self, tick: int) -> None:
        if self.is_over:
            return
        if tick in self.unacknowledged:
            del self.unacknowledged[: self.unacknowledged.index(tick) + 1]
        self.outbox.acknowledge(tick)
        self.pump()

    def end(self, why: Any) -> None:
        """The server closes the connection."""
        self.is_over = True
        self.server.left(self, self.host)
        self.viewer.ended(self, why)

    def cut(self) -> None:
        """It breaks: neither side can send any more."""
        self.is_over = self.down.is_cut = self.up.is_cut = True
        self.viewer.ended(self, "cut")
