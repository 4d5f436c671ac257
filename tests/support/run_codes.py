"""Translates the reasons of verdicts into codes, which stay the same when the sentences change."""

import re

REASONS = (  # the first pattern that fits decides
    ("TOUCHED", r"touched at .* into the tick"),
    ("SENSED", r"sensed: .*"),
    ("BUFFER_OVER", r"(the cell is blank|nothing in the cell is true), and .* s are over"),
    ("BLANK", r"the cell is blank"),
    ("NOTHING_TRUE", r"nothing in the cell is true"),
    ("BUFFERED", r"it waits for .* s"),
    ("OFF", r"the cell is -"),
    ("UNDEFINED_STATE", r"\S* is no state"),
    ("UNTIL_END", r"the cell says: at end"),
    ("UNTIL_MARKER", r"the cell says: at marker .*"),
    ("UNTIL_WINDOW", r"the cell says: window .*"),
    ("ENDED", r"the motion has ended"),
    ("AT_END", r"at the end of the motion"),
    ("WINDOW_OPEN", r"window .* has come"),
    ("MARKER_PASSED", r"marker .* has come"),
    ("IDLE", r"nothing else happened at the end of the motion"),
    ("DRAWN", r"drawn, .* of .*"),
    ("ELSE", r"since nothing before it is true"),
    ("SINCE", r"since .*"),
    ("STAYS", r"stays"),
    ("ARRIVED", r"arrived, the journey is over"),
    ("LEFT_BEFORE_END", r"\S+ was left before its end"),
    ("LEFT_BEFORE_MARKER", r"\S+ was left before its marker \S+"),
    ("LEFT_BEFORE_WINDOW", r"\S+ was left before its window .*"),
    ("RELEASED", r"it was released"),
    ("HELD_ALREADY", r"it is held already"),
    ("CHANGES_LIMIT", r"8 changes were made in this tick"),
    ("QUEUE_LIMIT", r"more than 16 were waiting, and it was the oldest"),
    ("RAISED_LIMIT", r"more than 16 events were raised on it in one tick"),
    ("NO_SUCH_EVENT", r"\S+ has no event \S+"),
    ("NO_SUCH_GOAL", r"\S+ has no state \S+"),
    ("STATE_GONE", r"the edit has no state \S+"),
    ("EVENT_GONE", r"the edit has no such event"),
    ("NO_OTHER", r"there is no other"),
    ("NOBODY_CALLED", r"(nobody here|no actor) is called \S+"),
    ("NOBODY_KNOWS", r"(nobody else|no other actor) knows \S+"),
)
_PATTERNS = [(code, re.compile(pattern)) for code, pattern in REASONS]


def codes(reason: str) -> tuple[str, ...]:
    """Returns the codes of a reason; a part that no pattern fits stays as it is, after a question mark."""
    return tuple(_code(part) for part in reason.split("; ") if part)


def _code(part: str) -> str:
    return next((code for code, pattern in _PATTERNS if pattern.fullmatch(part)), f"? {part}")
