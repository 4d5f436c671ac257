"""Encodes the frames of a stage once for all its viewers."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable, Sequence

from statwalk.character.role import Role
from statwalk.errors import StageError
from statwalk.services.publish import pose_message
from statwalk.services.publish.fanout import Fanout
from statwalk.services.publish.gltf_frames import GlbFrames
from statwalk.services.publish.layout import CastLayout, FrameLayout
from statwalk.services.publish.outbox import EncodedFrame, FrameForm
from statwalk.stage.state.frame import CastFrame, Frame

MOST_LAYOUTS = 16
Describe = Callable[[CastFrame], CastLayout]
"""returns the layout of a cast; called if a frame's actors differ from the frames that the
encoder remembers
"""


class Encoder:
    """Encodes the frames of one stage, and publishes them. Thread-safe."""

    def __init__(self) -> None:
        self.fanout = Fanout()
        self.glb = GlbFrames()
        self.layouts: OrderedDict[tuple[tuple[Role, bytes], ...], FrameLayout] = OrderedDict()
        self.epoch = 0
        self.lock = threading.Lock()

    def show(self, frame: Frame, head: int, describe: Describe, facts: Sequence[bytes]) -> None:
        """Publishes a frame in the forms that viewers watch, and encoded facts.

        `head`: the newest tick of the stage.
        """
        frames = {
            form: encoded
            for form in self.fanout.forms()
            if (encoded := self._try_encode(frame, form, head, describe))
        }
        self.fanout.publish(frames, facts)

    def encode(self, frame: Frame, form: FrameForm, head: int, describe: Describe) -> EncodedFrame:
        """Returns a frame as a binary message.

        :raises StageError: when the frame is too large.
        """
        layout = self.layout(frame, describe)
        data = (
            self.glb.streamed(frame, layout.epoch, form.skinning)
            if form.kind == "glb"
            else pose_message.encode(frame, layout.epoch, head)
        )
        return EncodedFrame(frame.tick, form.kind, layout, data, form.skinning)

    def layout(self, frame: Frame, describe: Describe) -> FrameLayout:
        """Returns the layout of a frame.

        Frames with the same actors and the same versions of machines share a layout and its epoch, while the
        encoder remembers it: it keeps `MOST_LAYOUTS`.
        """
        key = tuple((cast.role, cast.ids.tobytes()) for cast in frame.casts)
        with self.lock:
            if key not in self.layouts:
                self.epoch += 1
                self.layouts[key] = FrameLayout(self.epoch, tuple(describe(cast) for cast in frame.casts))
                if len(self.layouts) > MOST_LAYOUTS:
                    self.layouts.popitem(last=False)
            self.layouts.move_to_end(key)
            return self.layouts[key]

    def _try_encode(
        self, frame: Frame, form: FrameForm, head: int, describe: Describe
    ) -> EncodedFrame | None:
        """Returns None if the frame is too large: the viewers of this form are disconnected, the
        stage runs on.
        """
        try:
            return self.encode(frame, form, head, describe)
        except StageError as error:
            self.fanout.end("too large", str(error)[:100], form)
            return None
