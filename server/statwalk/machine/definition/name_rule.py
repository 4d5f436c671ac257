"""Checks names of states, events, markers and parameters, and says what is wrong with a refused name."""

from __future__ import annotations

import re
import unicodedata

MOST_LETTERS = 100
NAME = re.compile(rf"\w[\w.-]{{0,{MOST_LETTERS - 1}}}")


def refused_name(text: str, kind: str) -> str:
    """Returns the sentence that refuses a text as a name for the `kind`; the text must not match `NAME`."""
    return (
        f"{text[:40]!r} is no name for the {kind}: {_fault(text)}; use letters, digits, _, and later . or -"
    )


def _fault(text: str) -> str:
    if len(text) > MOST_LETTERS:
        return f"it has more than {MOST_LETTERS} letters"
    wrong = next((letter for letter in text if not re.fullmatch(r"[\w.-]", letter)), "")
    if wrong:
        return f"it has {_called(wrong)}"
    return f"it begins with {text[0]}" if text else "it is empty"


def _called(letter: str) -> str:
    """How a message calls a letter: one that is printed by itself stands there as it is."""
    if letter == " ":
        return "a space"
    if letter.isprintable() and not unicodedata.combining(letter):
        return letter
    name = unicodedata.name(letter, "a control character").lower()
    return f"U+{ord(letter):04X}, {name}"
