"""The numbers of a data object, read in order; a count is checked against the numbers that follow before any
memory is taken for them.
"""

from __future__ import annotations

import warnings

import numpy as np

from statwalk.errors import TextError
from statwalk.files.directx.x_objects import DataObject
from statwalk.maths.arrays import Floats, Ints

LARGEST_NUMBER = 1e30
MOST_NUMBERS = 12_000_000
_SEPARATORS = str.maketrans(";,", "  ")


class NumberReader:
    """Hands out the numbers of an object; `at` is the index of the next one."""

    def __init__(self, owner: DataObject) -> None:
        self.owner, self.at = owner, 0
        self.values = _values(owner)

    @property
    def left(self) -> int:
        """Returns how many numbers follow."""
        return len(self.values) - self.at

    def floats(self, count: int, what: str) -> Floats:
        """Returns the next `count` numbers (count,).

        :raises TextError: when fewer follow.
        """
        if count > self.left:
            raise self.refuse(f"{count} numbers should follow for {what}, but {self.left} follow")
        self.at += count
        return self.values[self.at - count : self.at]

    def count(self, what: str, width: int = 1) -> int:
        """Returns the next number, a whole number that says how many items of at least `width` numbers
        follow.

        :raises TextError: when it is not a whole number, or fewer numbers follow.
        """
        number = float(self.floats(1, what)[0])
        if number < 0 or number != int(number) or number * width > self.left:
            self.at -= 1
            raise self.refuse(f"{number:g} {what} cannot be: {self.left - 1} numbers follow")
        return int(number)

    def indices(self, count: int, below: int, what: str) -> Ints:
        """Returns the next `count` numbers as whole numbers from 0 to `below` - 1.

        :raises TextError: when one is something else.
        """
        values = self.floats(count, what)
        wrong = np.flatnonzero((values < 0) | (values >= below) | (values != np.floor(values)))
        if len(wrong):
            self.at += int(wrong[0]) - count
            raise self.refuse(f"{what}: {values[wrong[0]]:g} should be a whole number from 0 to {below - 1}")
        return values.astype(np.int64)

    def end(self) -> None:
        """Checks that no number is left.

        :raises TextError: when numbers are left.
        """
        if self.left:
            raise self.refuse(f"{self.owner.title} has {self.left} numbers more than its counts say")

    def refuse(self, message: str) -> TextError:
        """Returns the error for the next number."""
        return TextError(message, place=f"line {_line_of(self.owner, self.at)}")


def _values(owner: DataObject) -> Floats:
    text = " ".join(text for _, text in owner.pieces).translate(_SEPARATORS)
    count = _words_in(text)
    if count > MOST_NUMBERS:
        raise TextError(
            f"{owner.title} has {count} numbers; at most {MOST_NUMBERS} are read", place=owner.place
        )
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            values = np.fromstring(text, np.float64, sep=" ") if count else np.zeros(0)
    except (ValueError, DeprecationWarning):
        values = np.zeros(0)
    if len(values) != count or not (np.abs(values) <= LARGEST_NUMBER).all():
        raise _refusal(owner)
    return values


def _words_in(text: str) -> int:
    letters = np.frombuffer(text.encode("utf-8", "replace"), np.uint8)
    is_space = letters <= 32
    return int(np.count_nonzero(is_space[:-1] & ~is_space[1:])) + int(len(letters) > 0 and not is_space[0])


def _refusal(owner: DataObject) -> TextError:
    """Returns the error that names the first word which is not a number."""
    for start, text in owner.pieces:
        for line, words in enumerate(text.translate(_SEPARATORS).split("\n"), start):
            for word in words.split():
                if not _is_number(word):
                    return TextError(
                        f"{word[:80]!r} is no number within {LARGEST_NUMBER:g}", place=f"line {line}"
                    )
    return TextError(f"{owner.title} cannot be read as numbers", place=owner.place)


def _is_number(word: str) -> bool:
    try:
        return abs(float(word)) <= LARGEST_NUMBER and "_" not in word
    except ValueError:
        return False


def _line_of(owner: DataObject, index: int) -> int:
    """Returns the line of the number with this index; the last line of the object's numbers if it has
    fewer."""
    line = owner.line
    for start, text in owner.pieces:
        for line, words in enumerate(text.translate(_SEPARATORS).split("\n"), start):
            index -= len(words.split())
            if index < 0:
                return line
    return line
