"""Changes motions: the clips of a state's blend, markers, and when feet stand in a clip."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from statwalk.files.machine_yaml.edit.operation import EditOperation, Part
from statwalk.files.machine_yaml.edit.table_levels import existing_state, read
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.files.yaml.yaml_edit import moved, with_value, without
from statwalk.files.yaml.yaml_places import Path, find
from statwalk.machine.definition.machine_definition import BASE


@dataclass(frozen=True)
class SetBlendClip(EditOperation):
    """Puts a clip at a point of a state's blend, or moves it there; `at` has a number for each parameter."""

    state: str
    clip: str
    at: float | tuple[float, float]
    layer: str = BASE

    def __str__(self) -> str:
        return f"{self.state}: clip {self.clip}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the clip."""
        at = self.at if isinstance(self.at, int | float) else list(self.at)
        return text._replace(yaml=with_value(text.yaml, (*_blend(text, self), "clips", self.clip), at))

    def touched(self) -> Iterable[Part]:
        """The state, and the clip."""
        yield "name", "state", self.layer, self.state
        yield "state", self.layer, self.state, "motion", "clips", self.clip


@dataclass(frozen=True)
class DeleteBlendClip(EditOperation):
    """Takes a clip out of a state's blend, with its markers."""

    state: str
    clip: str
    layer: str = BASE

    def __str__(self) -> str:
        return f"{self.state}: without the clip {self.clip}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text without the clip."""
        path = _blend(text, self)
        _check_clip(text, path, self.clip)
        yaml = without(text.yaml, (*path, "clips", self.clip), len(path) + 1)
        return text._replace(yaml=without(yaml, (*path, "markers", self.clip), len(path)))

    def touched(self) -> Iterable[Part]:
        """The state, and the clip with its markers."""
        yield "name", "state", self.layer, self.state
        yield "state", self.layer, self.state, "motion", "clips", self.clip
        yield "state", self.layer, self.state, "motion", "markers", self.clip


@dataclass(frozen=True)
class MoveBlendClip(EditOperation):
    """Moves a clip of a state's blend before another, or to the end. Phases of the state are phases of its
    first clip.
    """

    state: str
    clip: str
    before: str | None = None
    layer: str = BASE

    def __str__(self) -> str:
        return f"{self.state}: clip {self.clip} moved"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the clips in the other order."""
        path = _blend(text, self)
        for clip in (self.clip, self.before):
            if clip is not None:
                _check_clip(text, path, clip)
        return text._replace(yaml=moved(text.yaml, (*path, "clips", self.clip), self.before))

    def touched(self) -> Iterable[Part]:
        """The state, and the clip."""
        yield "name", "state", self.layer, self.state
        yield "state", self.layer, self.state, "motion", "clips", self.clip


def _blend(text: MachineText, where: SetBlendClip | DeleteBlendClip | MoveBlendClip) -> Path:
    """The path to the blend of a state. :raises MachineError: when the state plays no blend."""
    level, name = existing_state(read(text), where.layer, where.state)
    path = (*level.path, "states", name, "motion")
    motion = find(read(text), path)
    if motion is None or not motion.is_mapping or "clips" not in motion.entries():
        raise (motion or level.states()[name]).refuse(
            f"{where.state} plays no blend; set its motion to one, with `over` and two `clips`, first"
        )
    return path


def _check_clip(text: MachineText, blend: Path, clip: str) -> None:
    """Checks that a blend has a clip. :raises MachineError: when it has none of this name."""
    clips = find(read(text), (*blend, "clips"))
    if clips is not None and clip not in clips.entries():
        raise clips.unknown("clip of the blend", clip, clips.entries())


@dataclass(frozen=True)
class SetMarker(EditOperation):
    """Puts a marker at a phase 0…1 of a state's motion (`clip`: of one clip of its blend), or (None) removes
    it.
    """

    state: str
    marker: str
    phase: float | None
    clip: str = ""
    layer: str = BASE

    def __str__(self) -> str:
        return f"{self.state}: marker {self.marker}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the marker, or without."""
        level, name = existing_state(read(text), self.layer, self.state)
        state = (*level.path, "states", name)
        path = (*state, *self._markers(), self.marker)
        if self.phase is not None:
            return text._replace(yaml=with_value(text.yaml, path, self.phase))
        if find(read(text), path) is None:
            node = find(read(text), path[:-1])
            raise level.states()[name].unknown("marker", self.marker, node.entries() if node else ())
        return text._replace(yaml=without(text.yaml, path, len(state)))

    def _markers(self) -> Path:
        return ("motion", "markers", self.clip) if self.clip else ("markers",)

    def touched(self) -> Iterable[Part]:
        """The state, and the marker."""
        yield "name", "state", self.layer, self.state
        clip = ("motion", "markers", self.clip) if self.clip else ("markers",)
        yield ("state", self.layer, self.state, *clip, self.marker)


@dataclass(frozen=True)
class SetContacts(EditOperation):
    """Says in which spans of phase a foot stands in a clip; None: as found from the clip."""

    clip: str
    foot: str
    spans: Sequence[Sequence[float]] | None

    def __str__(self) -> str:
        return f"{self.clip}: contacts of {self.foot}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the spans, or without."""
        path = "contacts", self.clip, self.foot
        if self.spans is None:
            return text._replace(yaml=without(text.yaml, path))
        return text._replace(yaml=with_value(text.yaml, path, [list(span) for span in self.spans]))

    def touched(self) -> Iterable[Part]:
        """The foot in the clip."""
        yield "contacts", self.clip, self.foot
