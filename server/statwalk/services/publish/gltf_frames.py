"""Posed frames of one stage as GLB; each layout has a template, made on first use."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Sequence

from statwalk.errors import StageError
from statwalk.files.gltf.template import FrameTemplate, PosedCast
from statwalk.stage.state.frame import CastFrame, Frame

MOST_VERTICES = 1_000_000
"""the vertices of all actors together: a frame of 24 MB"""
MOST_TEMPLATES = 2
"""one for the present, one for a past tick with other actors"""


class GlbFrames:
    """Keeps the templates of the last streamed layouts. Thread-safe."""

    def __init__(self) -> None:
        self.templates: OrderedDict[int, FrameTemplate] = OrderedDict()
        self.lock = threading.Lock()

    def streamed(self, frame: Frame, epoch: int) -> bytes:
        """Returns a frame of a stream as a GLB without images.

        :raises StageError: when the actors have too many vertices together.
        """
        with self.lock:
            if epoch not in self.templates:
                self.templates[epoch] = _template_for(frame, images=False)
            self.templates.move_to_end(epoch)
            while len(self.templates) > MOST_TEMPLATES:
                self.templates.popitem(last=False)
            template = self.templates[epoch]
        return _filled(template, frame)


def whole(frame: Frame) -> bytes:
    """Returns one frame as a complete GLB with images.

    :raises StageError: when the actors have too many vertices together.
    """
    return _filled(_template_for(frame, images=True), frame)


def _template_for(frame: Frame, *, images: bool) -> FrameTemplate:
    check_size(frame.casts)
    return FrameTemplate([(cast.role.character, len(cast.ids)) for cast in frame.casts], images=images)


def check_size(casts: Sequence[CastFrame]) -> None:
    """Counts the vertices before any memory is allocated.

    :raises StageError: when the actors have too many vertices together.
    """
    vertices = sum(
        len(cast.ids) * sum(len(part.positions) for part in cast.role.character.parts) for cast in casts
    )
    if vertices > MOST_VERTICES:
        raise StageError(
            f"the actors have {vertices} vertices together; a GLB frame may have {MOST_VERTICES}. Watch pose "
            "frames: they have no limit"
        )


def _filled(template: FrameTemplate, frame: Frame) -> bytes:
    return template.frame(
        frame.tick,
        frame.hash,
        [PosedCast(cast.pose, cast.root_position, cast.heading) for cast in frame.casts],
    )
