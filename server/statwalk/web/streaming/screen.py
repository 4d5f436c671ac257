"""What the viewers of a stage see: frames encoded once for all of them, and the layouts that their hellos describe."""

from __future__ import annotations

import threading
from collections import OrderedDict
from typing import Any

from statwalk.errors import StageError
from statwalk.stage.frame import Frame
from statwalk.stage.role import Role
from statwalk.stage.stage import Stage
from statwalk.web.keeping.catalogue import Catalogue
from statwalk.web.streaming import messages, wire
from statwalk.web.streaming.broadcast import Broadcast
from statwalk.web.streaming.glbframes import GlbFrames
from statwalk.web.streaming.mailbox import FrameKind, Layout, Shown

MOST_LAYOUTS = 16
REFUSED = 4013


class Screen:
    """The viewers of one stage and what is made for them. Safe to use from several threads."""

    def __init__(self, catalogue: Catalogue) -> None:
        self.catalogue = catalogue
        self.broadcast = Broadcast()
        self.glb = GlbFrames()
        self.layouts: OrderedDict[tuple[tuple[Role, bytes], ...], Layout] = OrderedDict()
        self.epoch = 0
        self.lock = threading.Lock()

    def show(self, stage: Stage, *, facts: bool) -> None:
        """Publishes the frame at the playhead, in the kinds that are watched, and (`facts`) what happened in its tick."""
        if not self.broadcast.mailboxes:
            return
        frame = stage.frame
        shown = {kind: made for kind in self.broadcast.kinds() if (made := self.made(frame, kind, stage))}
        happened = [messages.action(done) for done in frame.actions] + [messages.verdict(given) for given in frame.verdicts]
        self.broadcast.publish(shown, happened if facts else ())

    def made(self, frame: Frame, kind: FrameKind, stage: Stage) -> Shown | None:
        """A frame as a message; where it cannot be made, those who watch that kind are sent away, and the stage goes on."""
        try:
            return self.encode(frame, kind, stage, stage.head)
        except StageError as error:
            self.broadcast.end(REFUSED, str(error)[:100], kind)
            return None

    def encode(self, frame: Frame, kind: FrameKind, stage: Stage, head: int) -> Shown:
        """A frame as a message; `stage` is the one it comes from, which knows the actors' names; `head` the newest tick there is.

        :raises StageError: if the frame would be too large.
        """
        layout = self.layout(frame, stage)
        data = self.glb.streamed(frame, layout.epoch) if kind == "glb" else wire.encode(frame, layout.epoch, head)
        return Shown(frame.tick, kind, layout, data)

    def layout(self, frame: Frame, stage: Stage) -> Layout:
        """The layout of a frame: the same epoch for the same actors of the same version of a machine, as long as it is remembered."""
        key = tuple((cast.role, cast.ids.tobytes()) for cast in frame.casts)
        with self.lock:
            if key not in self.layouts:
                self.epoch += 1
                self.layouts[key] = Layout(self.epoch, self.describe(frame, stage))
                if len(self.layouts) > MOST_LAYOUTS:
                    self.layouts.popitem(last=False)
            self.layouts.move_to_end(key)
            return self.layouts[key]

    def describe(self, frame: Frame, stage: Stage) -> tuple[dict[str, Any], ...]:
        """The hello's casts."""

        def name(actor: int) -> str:
            return stage.actor(actor).name

        numbers = {role: number for number, role in enumerate(stage.roles.values(), 1)}  # rising, whatever else was edited
        return tuple(messages.describe_cast(cast, self.catalogue.character_of(cast.role), numbers[cast.role], name) for cast in frame.casts)
