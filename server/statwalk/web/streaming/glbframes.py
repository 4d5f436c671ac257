"""Posed frames as GLB for one stage: the templates that its layouts need, made when somebody first watches them."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Sequence

from statwalk.errors import StageError
from statwalk.files.glb.template import FrameTemplate, PosedCast
from statwalk.stage.frame import CastFrame, Frame

MOST_VERTICES = 1_000_000
"""of all actors together: a frame of 24 MB"""


MOST_TEMPLATES = 2
"""one for the present, one for whoever looks at a past with other actors"""


class GlbFrames:
    """Keeps the templates of the layouts that were streamed last. Safe to use from several threads."""

    def __init__(self) -> None:
        self.templates: OrderedDict[int, FrameTemplate] = OrderedDict()
        self.lock = threading.Lock()

    def streamed(self, frame: Frame, epoch: int) -> bytes:
        """A frame of a stream, without images.

        :raises StageError: if the actors have too many vertices together.
        """
        with self.lock:
            if epoch not in self.templates:
                self.templates[epoch] = template_for(frame, images=False)
            self.templates.move_to_end(epoch)
            while len(self.templates) > MOST_TEMPLATES:
                self.templates.popitem(last=False)
            template = self.templates[epoch]
        return filled(template, frame)


def whole(frame: Frame) -> bytes:
    """One frame with its images, for a file.

    :raises StageError: if the actors have too many vertices together.
    """
    return filled(template_for(frame, images=True), frame)


def template_for(frame: Frame, *, images: bool) -> FrameTemplate:
    """The template for the actors of a frame."""
    check_size(frame.casts)
    return FrameTemplate([(cast.role.character, len(cast.ids)) for cast in frame.casts], images=images)


def check_size(casts: Sequence[CastFrame]) -> None:
    """Refuses what would not fit, before memory is taken."""
    vertices = sum(len(cast.ids) * sum(len(part.positions) for part in cast.role.character.parts) for cast in casts)
    if vertices > MOST_VERTICES:
        raise StageError(f"the actors have {vertices} vertices together; a GLB frame may have {MOST_VERTICES}; pose frames have no limit")


def filled(template: FrameTemplate, frame: Frame) -> bytes:
    """The template with a frame's poses."""
    return template.frame(frame.tick, frame.hash, [PosedCast(cast.pose, cast.root_position, cast.heading) for cast in frame.casts])
