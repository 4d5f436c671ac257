"""Posed frames of one stage as GLB; each layout has a template, made on first use."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Sequence

from statwalk.character.character import Character
from statwalk.errors import StageError
from statwalk.files.gltf.template import FrameTemplate, PosedCast
from statwalk.skin.skinning import SKINNINGS, Skinning
from statwalk.stage.state.frame import CastFrame, Frame

MOST_VERTICES = 1_000_000
"""the vertices of all actors together: a frame of 24 MB"""
MOST_TEMPLATES = 1 + len(SKINNINGS)
"""one for each way of skinning of the present, one for a past tick with other actors"""


class GlbFrames:
    """Keeps the templates of the last streamed layouts. Thread-safe."""

    def __init__(self) -> None:
        self.templates: OrderedDict[tuple[int, Skinning | None], FrameTemplate] = OrderedDict()
        self.lock = threading.Lock()

    def streamed(self, frame: Frame, epoch: int, skinning: Skinning | None = None) -> bytes:
        """Returns a frame of a stream as a GLB without images; `skinning` None: each character's own.

        :raises StageError: when the actors have too many vertices together.
        """
        with self.lock:
            key = epoch, skinning
            if key not in self.templates:
                self.templates[key] = _template_for(frame, skinning, images=False)
            self.templates.move_to_end(key)
            while len(self.templates) > MOST_TEMPLATES:
                self.templates.popitem(last=False)
            template = self.templates[key]
        return _filled(template, frame)


def whole(frame: Frame, skinning: Skinning | None = None) -> bytes:
    """Returns one frame as a complete GLB with images; `skinning` None: each character's own.

    :raises StageError: when the actors have too many vertices together.
    """
    return _filled(_template_for(frame, skinning, images=True), frame)


def _template_for(frame: Frame, skinning: Skinning | None, *, images: bool) -> FrameTemplate:
    check_size(frame.casts, skinning)
    entries = [(_character(cast, skinning), len(cast.ids)) for cast in frame.casts]
    return FrameTemplate(entries, images=images)


def _character(cast: CastFrame, skinning: Skinning | None) -> Character:
    return cast.role.character.skinned(skinning or cast.role.character.skinning)


def check_size(casts: Sequence[CastFrame], skinning: Skinning | None = None) -> None:
    """Counts the vertices before memory is allocated for frames.

    :raises StageError: when the actors have too many vertices together.
    """
    vertices = sum(
        len(cast.ids) * sum(len(part.positions) for part in _character(cast, skinning).shown_parts)
        for cast in casts
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
