"""Makes the layouts of the frames of a stage."""

from __future__ import annotations

from collections.abc import Callable

from statwalk.services.library.catalogue import Catalogue
from statwalk.services.publish.layout import CastLayout, cast_layout
from statwalk.stage.stage import Stage
from statwalk.stage.state.frame import CastFrame


def layouts_of(stage: Stage, catalogue: Catalogue) -> Callable[[CastFrame], CastLayout]:
    """Returns the function that makes the layouts of the frame that `stage` shows now."""
    roles, name_of = tuple(stage.roles.values()), stage.state.names.__getitem__

    def layout(cast: CastFrame) -> CastLayout:
        character = catalogue.character_of(cast.role)
        version = 1 + roles.index(cast.role)  # rises with each edit
        return cast_layout(cast, character, version, name_of)

    return layout
