"""The bodies about captured motions: the bones of a character, and a clip that is carried over."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from statwalk.motion.filter_clip import HIGHEST_CUTOFF
from statwalk.web.schemas.base import FileName, Name, RequestModel, ResponseModel

MOST_BONES = 200
Seconds = Annotated[float, Field(ge=0, le=36_000)]
JointName = Annotated[str, Field(max_length=200)]
Bones = Annotated[dict[str, JointName], Field(max_length=MOST_BONES)]


class NewClip(RequestModel):
    """A clip of another character, to be carried over."""

    source: Name
    """the character that has the clip: an uploaded .bvh or .trc, or any other"""
    clip: Annotated[str, Field(max_length=200)] = ""
    """empty: the source's first clip"""
    name: Annotated[str, Field(max_length=80)] = ""
    """the new clip's name; empty: the clip's own"""
    character: FileName | None = None
    """the name of the character with the clip; by default the uploaded character itself gets it"""
    bones: Bones = Field(default_factory=dict)
    """the source's joint of a bone whose name does not tell it; an empty joint: none"""
    target_bones: Bones = Field(default_factory=dict)
    """the same for the character"""
    start: Seconds = 0.0
    """the piece that is carried over begins here, in seconds"""
    end: Seconds | None = None
    """and ends here; null: at the clip's end"""
    low_pass: Annotated[float, Field(ge=0, le=HIGHEST_CUTOFF)] = 0.0
    """Hz: what moves faster is taken out, without a delay; 0: nothing"""
    spikes: bool = False
    """whether single wild samples are replaced"""
    loop: bool = False
    """whether the clip repeats"""


class JointPair(ResponseModel):
    """The joints that are one bone; `source` is empty where the spine turns as a whole."""

    source: str
    target: str


class NewClipView(ResponseModel):
    """A clip that was carried over, and how.

    missing: bones of hips and legs that one of the two lacks. unmapped_source: joints that move, and whose
    motion no joint takes. unmapped_target: joints that no motion reaches. scale: the character's metres per
    unit of the source. root: the joint that travels.
    """

    character: str
    clip: str
    duration: float
    root: str
    bones: dict[str, JointPair]
    missing: list[str]
    unmapped_source: list[str]
    unmapped_target: list[str]
    scale: float
    notes: list[str]


class BonesView(ResponseModel):
    """The joint of each bone that the names of a character tell; `needed` are the bones without which no walk
    is carried over, `known` all names of bones.
    """

    character: str
    bones: dict[str, str]
    needed: list[str]
    known: list[str]
