"""Splits the text of a formula into words: numbers, names, signs, each with its column."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal

LONGEST = 500
LONGEST_NUMBER = 30
WORD = re.compile(
    r"\s*(?:(?P<number>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)|(?P<name>[A-Za-z_][A-Za-z0-9_]*(?:\.[A-Za-z_][A-Za-z0-9_]*)?)|(?P<sign><=|>=|==|!=|[-+*/%<>(),]))"
)
HINTS = {
    "=": "`==` compares",
    "&": "write `and`",
    "|": "write `or`",
    "!": "write `not`",
    "^": "write pow(a, b)",
    ".": "a name has at most one dot, between letters: reach.x",
}

DOTTED = re.compile(
    r"\s*(?:(?P<number>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)"
    r"|(?P<name>(?:'[^']+'|[A-Za-z_][A-Za-z0-9_]*)(?:\.[A-Za-z0-9_]+)*)|(?P<sign><=|>=|==|!=|[-+*/%<>(),]))"
)
"""words of an expression: names have parts, `gear_a.rotate_z`; quotes hold any letters, `'Left arm'.scale_x`
"""

Kind = Literal["number", "name", "sign", "end"]


class ConditionError(Exception):
    """An error about a formula that cannot be read; `column` counts from 1.

    Callers that know file and line convert it to a ContentError.
    """

    def __init__(self, message: str, column: int) -> None:
        super().__init__(f"{message} (column {column})")
        self.message, self.column = message, column


@dataclass(frozen=True)
class Word:
    """A word of the text."""

    kind: Kind
    text: str
    column: int


def words_of(text: str, pattern: re.Pattern[str] = WORD) -> list[Word]:
    """Returns the words of a text, and an `end` after the last; `pattern` is WORD or DOTTED.

    :raises ConditionError: when a character belongs to no word, or the text has more than 500 characters.
    """
    if len(text) > LONGEST:
        raise ConditionError(f"the formula is longer than {LONGEST} characters", LONGEST + 1)
    words: list[Word] = []
    position, end = 0, len(text.rstrip())
    while position < end:
        match = pattern.match(text, position)
        if match is None:
            raise _meaningless(text, position)
        kind: Kind = "number" if match["number"] else "name" if match["name"] else "sign"
        words.append(Word(kind, match[kind].replace("'", ""), match.start(kind) + 1))
        position = match.end()
    return [*words, Word("end", "", end + 1)]


def as_written(name: str) -> str:
    """Returns a name as an expression writes it: in quotes if it has other characters than letters, digits, _
    and dots.
    """
    match = DOTTED.fullmatch(name)
    if match is not None and match["name"]:
        return name
    owner, dot, channel = name.rpartition(".")
    return f"'{owner}'.{channel}" if dot else f"'{name}'"


def _meaningless(text: str, position: int) -> ConditionError:
    while text[position].isspace():
        position += 1
    letter = text[position]
    hint = (
        f"; {HINTS[letter]}"
        if letter in HINTS
        else "; there are only numbers, names, + - * / % < <= > >= == != ( ) and commas"
    )
    return ConditionError(f"{letter!r} has no meaning here{hint}", position + 1)
