"""The tables of a TRC file: a head of five lines, then a row for each frame: number, time, x y z of every
marker.

    PathFileType  4  (X/Y/Z)  walk.trc
    DataRate  CameraRate  NumFrames  NumMarkers  Units  OrigDataRate  OrigDataStartFrame  OrigNumFrames
    100       100         300        41          mm     100           1                   300
    Frame#    Time        RASI                   LASI                 …
                          X1   Y1   Z1           X2   Y2   Z2         …
    1         0.00        …

A marker that the cameras lost has blank fields, or 0 0 0.
"""

from __future__ import annotations

from math import isfinite
from typing import NamedTuple

import numpy as np

from statwalk.errors import TextError
from statwalk.maths.arrays import Floats

MOST_MARKERS = 2_000
LARGEST_NUMBER = 1e9
FASTEST_RATE = 1e5
METRES = {"mm": 1e-3, "cm": 1e-2, "m": 1.0, "in": 0.0254, "ft": 0.3048, "meters": 1.0, "dm": 0.1}
_NEEDED = ("DataRate", "NumFrames", "NumMarkers", "Units")


class Tracks(NamedTuple):
    """Marker tracks.

    names     of the M markers
    times     (F,) seconds from 0
    places    (F, M, 3) metres; NaN where a marker was lost
    """

    names: tuple[str, ...]
    times: Floats
    places: Floats


def read_tracks(text: str) -> Tracks:
    """Reads the tracks of a TRC file.

    :raises TextError: when the head or a row is wrong, or there are more or fewer rows than the head says;
        `place` is the line.
    """
    lines = text.split("\n", 5)
    if len(lines) < 6 or not lines[0].strip().upper().startswith("PATHFILETYPE"):
        raise TextError("a TRC file begins with PathFileType and has a head of five lines", place="line 1")
    head = _head(lines[1], lines[2])
    names = _names(lines[3], int(head["NumMarkers"]))
    places = _rows(lines[5], int(head["NumFrames"]), len(names)) * METRES[head["Units"]]
    rate = float(head["DataRate"])
    return Tracks(names, np.arange(len(places)) / rate, places)


def _head(keys: str, values: str) -> dict[str, str]:
    """Returns the values of the head by their keys, checked."""
    head = dict(zip(keys.split(), values.split(), strict=False))
    for key in _NEEDED:
        if key not in head:
            raise TextError(f"the head has no {key}", place="line 3" if key in keys else "line 2")
    for key in ("NumFrames", "NumMarkers"):
        if not (head[key].isascii() and head[key].isdecimal() and len(head[key]) <= 15):
            raise TextError(f"{key} should be a whole number, not {head[key][:40]!r}", place="line 3")
    if not 0 < _number(head["DataRate"]) <= FASTEST_RATE:
        raise TextError(f"DataRate should be frames a second, not {head['DataRate'][:40]!r}", place="line 3")
    head["Units"] = head["Units"].lower()
    if head["Units"] not in METRES:
        raise TextError(
            f"no unit is called {head['Units'][:40]!r}; known: {', '.join(METRES)}", place="line 3"
        )
    if not 0 < int(head["NumMarkers"]) <= MOST_MARKERS:
        raise TextError(
            f"a file may have 1 to {MOST_MARKERS} markers, not {head['NumMarkers']}", place="line 3"
        )
    return head


def _names(line: str, count: int) -> tuple[str, ...]:
    """Returns the markers' names; each stands over its three columns, or the names stand close together."""
    names = (
        [name.strip() for name in line.split("\t")[2:] if name.strip()] if "\t" in line else line.split()[2:]
    )
    if len(names) != count:
        raise TextError(f"NumMarkers says {count}, but {len(names)} markers are named", place="line 4")
    return tuple(name[:200] for name in names)


def _rows(body: str, frames: int, markers: int) -> Floats:
    """Returns the places (frames, markers, 3) in the file's unit; rows are counted before memory is taken."""
    rows = [(number, line) for number, line in enumerate(body.split("\n"), 6) if line.strip()]
    if rows and not any(
        letter.isdigit() and not word[0].isalpha() for word in rows[0][1].split()[:1] for letter in word
    ):
        rows = rows[1:]
    if len(rows) != frames:
        place = f"line {rows[-1][0] if rows else 6}"
        raise TextError(f"NumFrames says {frames}, but {len(rows)} rows follow", place=place)
    places = np.empty((frames, markers, 3))
    for row, (number, line) in enumerate(rows):
        places[row] = _places(line, number, markers)
    places[(places == 0).all(-1)] = np.nan
    return places


def _places(line: str, number: int, markers: int) -> Floats:
    fields = line.rstrip("\n").split("\t") if "\t" in line else line.split()
    while len(fields) > 3 * markers + 2 and not fields[-1].strip():
        fields.pop()
    fields += [""] * (3 * markers + 2 - len(fields)) if "\t" in line else []
    if len(fields) != 3 * markers + 2:
        raise TextError(
            f"a row has a number, a time and 3 × {markers} numbers, this one has {len(fields)}",
            place=f"line {number}",
        )
    values = np.array([_number(field) if field.strip() else np.nan for field in fields[2:]])
    wrong = [
        field for field, value in zip(fields[2:], values, strict=True) if field.strip() and np.isnan(value)
    ]
    wrong = [field for field in wrong if field.strip().lower() != "nan"]
    if wrong or (np.abs(values) > LARGEST_NUMBER).any():
        shown = wrong[0] if wrong else str(values[np.abs(values) > LARGEST_NUMBER][0])
        raise TextError(
            f"{shown.strip()[:40]!r} is no number within {LARGEST_NUMBER:g}", place=f"line {number}"
        )
    places = values.reshape(markers, 3)
    missing = np.isnan(places)
    if (cut := missing.any(1) & ~missing.all(1)).any():
        raise TextError(
            f"marker {cut.argmax() + 1} has some of its three numbers; a marker that is not seen has none",
            place=f"line {number}",
        )
    return places


def _number(word: str) -> float:
    """Returns the word as a number; NaN if it is none."""
    try:
        value = float(word)
    except ValueError:
        return float("nan")
    return value if isfinite(value) and "_" not in word else float("nan")
