"""The bodies about measurements: the figures of cells and motions, feet and their contacts."""

from __future__ import annotations

from math import isfinite

from statwalk.character.feet import Foot
from statwalk.character.foot_contacts import ClipContacts
from statwalk.rig.skeleton import Skeleton
from statwalk.stage.measure.figures import Figure
from statwalk.stage.measure.measure import Measured
from statwalk.web.schemas.base import ResponseModel
from statwalk.web.schemas.finding import FindingView

Spans = list[tuple[float, float]]


class SpotView(ResponseModel):
    """Where a trial began on the stage: metres and degrees."""

    x: float
    z: float
    heading_deg: float


class FigureView(ResponseModel):
    """One figure: its mean over the phases without interruptions, its worst, and where that is; null: never,
    for a response that does not come.
    """

    mean: float | None
    worst: float | None
    phase: float
    joint: str
    then: str
    """the event that interrupted the worst; empty: none"""
    ticks: int
    """after which it came"""
    place: SpotView
    """where the trial began that was the worst"""


class MeasuredView(ResponseModel):
    """The figures of a cell, or of a state's motion by itself (`event` empty)."""

    state: str
    event: str
    layer: str
    line: int
    trials: int
    figures: dict[str, FigureView]


class MeasurementsView(ResponseModel):
    """What was measured of a machine, in the units of the figures, and what is over the budgets of its
    file.
    """

    units: dict[str, str]
    budgets: dict[str, float]
    measured: list[MeasuredView]
    findings: list[FindingView]


class FootView(ResponseModel):
    """A foot and the joints of its leg; an empty name: none. `points` is the number of points of its sole."""

    name: str
    hip: str
    knee: str
    ankle: str
    toe: str
    points: int


class FootContactView(ResponseModel):
    """The spans of phase in which a foot stands on the ground, and in which its heel and its ball do."""

    foot: str
    planted: Spans
    heel: Spans
    ball: Spans


class ClipContactsView(ResponseModel):
    """The contacts of all feet in a clip."""

    clip: str
    feet: list[FootContactView]
    drift: tuple[float, float]
    """x, z (m/s) of the ground under a clip that walks on the spot"""


class FeetView(ResponseModel):
    """The feet of a character and their contacts in its clips."""

    feet: list[FootView]
    clips: list[ClipContactsView]


def measured_view(measured: Measured) -> MeasuredView:
    """Returns the view of a row of figures."""
    figures = {name: _figure_view(figure) for name, figure in measured.figures.items()}
    return MeasuredView(
        state=measured.state,
        event=measured.event,
        layer=measured.layer,
        line=measured.line,
        trials=measured.trials,
        figures=figures,
    )


def _figure_view(figure: Figure) -> FigureView:
    mean, worst = (value if isfinite(value) else None for value in (figure.mean, figure.worst))
    return FigureView(
        mean=mean,
        worst=worst,
        phase=figure.phase,
        joint=figure.joint,
        then=figure.then,
        ticks=figure.ticks,
        place=SpotView(**figure.place.plain()),
    )


def feet_view(skeleton: Skeleton, feet: tuple[Foot, ...], contacts: dict[str, ClipContacts]) -> FeetView:
    """Returns the view of feet and contacts."""
    return FeetView(
        feet=[_foot_view(skeleton, foot) for foot in feet],
        clips=[_contacts_view(clip) for clip in contacts.values()],
    )


def _foot_view(skeleton: Skeleton, foot: Foot) -> FootView:
    names = {part: getattr(foot, part) for part in ("hip", "knee", "ankle", "toe")}
    joints = {part: skeleton.names[joint] if joint >= 0 else "" for part, joint in names.items()}
    return FootView(name=foot.name, points=len(foot.points), **joints)


def _contacts_view(contacts: ClipContacts) -> ClipContactsView:
    feet = [
        FootContactView(foot=foot.foot, planted=[*foot.planted], heel=[*foot.heel], ball=[*foot.ball])
        for foot in contacts.feet
    ]
    return ClipContactsView(clip=contacts.clip, feet=feet, drift=contacts.drift)
