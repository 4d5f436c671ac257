"""Parses the text of a formula (a condition, an expression) to its program, by precedence (Pratt 1973): the
steps are emitted in postfix order.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from difflib import get_close_matches

from statwalk.maths.formula.operations import CONSTANTS, FUNCTIONS, LARGEST, OPERATORS
from statwalk.maths.formula.postfix import Formula, Step
from statwalk.maths.formula.tokens import WORD, ConditionError, Word, words_of

DEEPEST = 32
COMPARISONS = ("<", "<=", ">", ">=", "==", "!=")
POWER = {"or": 1, "and": 2, **dict.fromkeys(COMPARISONS, 4), "+": 5, "-": 5, "*": 6, "/": 6, "%": 6}
"""binding power of the binary operators"""
NOT_POWER, MINUS_POWER = 3, 7
RESERVED = (*FUNCTIONS, *CONSTANTS, "and", "or", "not")


def parse(text: str, scope: Sequence[str], pattern: re.Pattern[str] = WORD) -> Formula:
    """Returns the program of a formula over the names in `scope`; `pattern` DOTTED: names have parts.

    :raises ConditionError: when the text cannot be read; with column and nearest name.
    """
    parser = Parser(words_of(text, pattern), tuple(scope))
    parser.value(0, 0)
    if parser.word.kind != "end":
        raise parser.refuse("an operator or the end is wanted here, not")
    return Formula(text.strip(), tuple(scope), tuple(parser.steps))


class Parser:
    """A position in the words, and the steps of the words before it."""

    def __init__(self, words: list[Word], scope: tuple[str, ...]) -> None:
        self.words, self.scope = words, scope
        self.place = 0
        self.steps: list[Step] = []

    @property
    def word(self) -> Word:
        """Returns the next word without reading it."""
        return self.words[self.place]

    def next(self) -> Word:
        """Reads and returns the next word."""
        word = self.word
        self.place += word.kind != "end"
        return word

    def refuse(self, message: str) -> ConditionError:
        """Returns the error about the next word."""
        return ConditionError(
            f"{message} {self.word.text[:40]!r}" if self.word.text else f"{message} the end", self.word.column
        )

    def expect(self, sign: str) -> None:
        """Reads the given sign.

        :raises ConditionError: when the next word is another.
        """
        if self.word.text != sign:
            raise self.refuse(f"{sign!r} is wanted here, not")
        self.next()

    def value(self, power: int, depth: int) -> None:
        """Reads a value, and all operators after it that bind more strongly than `power`.

        :raises ConditionError: when the text cannot be read.
        """
        if depth > DEEPEST:
            raise self.refuse(f"the formula is more than {DEEPEST} deep here, at")
        self.beginning(depth)
        compared = False
        while (strength := POWER.get(self.word.text, 0)) > power:
            operator = self.word.text
            if operator in COMPARISONS and compared:
                raise self.refuse("two comparisons in a row are joined by `and`: a < x and x < b; not by")
            compared = operator in COMPARISONS
            self.next()
            self.value(strength, depth + 1)
            self.steps.append(OPERATORS[operator])

    def beginning(self, depth: int) -> None:
        """Reads a number, a name, a call, a bracketed value, or `not` and `-` with their operand.

        :raises ConditionError: when the next word begins no value.
        """
        word = self.word
        if word.text == "(":
            self.next()
            self.value(0, depth + 1)
            self.expect(")")
        elif word.text in ("-", "not"):
            self.next()
            self.value(MINUS_POWER if word.text == "-" else NOT_POWER, depth + 1)
            self.steps.append(OPERATORS["minus" if word.text == "-" else "not"])
        elif word.kind == "number":
            self.number(self.next())
        elif word.kind == "name" and word.text not in ("and", "or"):
            self.name(self.next(), depth)
        else:
            raise self.refuse("a number, a name or ( is wanted here, not")

    def number(self, word: Word) -> None:
        """Reads a number of at most ±1e300.

        :raises ConditionError: when the number is larger.
        """
        value = float(word.text)
        if value > LARGEST:
            raise ConditionError(f"{word.text[:40]} is more than {LARGEST:g}", word.column)
        self.steps.append(value)

    def name(self, word: Word, depth: int) -> None:
        """Reads a variable, a constant, or a call.

        :raises ConditionError: when the name is unknown.
        """
        if word.text in self.scope and self.word.text != "(":
            self.steps.append(word.text)
        elif word.text in CONSTANTS:
            self.steps.append(float(CONSTANTS[word.text]))
        elif word.text in FUNCTIONS:
            self.call(word, depth)
        else:
            raise self.unknown(word)

    def call(self, word: Word, depth: int) -> None:
        """Reads a function with its arguments.

        :raises ConditionError: when the number of arguments is wrong.
        """
        function = FUNCTIONS[word.text]
        self.expect("(")
        for number in range(function.takes):
            if number:
                self.expect(",")
            self.value(0, depth + 1)
        if self.word.text == ",":
            raise ConditionError(
                f"{word.text} takes {function.takes} value{'s' * (function.takes > 1)}, not more",
                self.word.column,
            )
        self.expect(")")
        self.steps.append(function)

    def unknown(self, word: Word) -> ConditionError:
        """Returns the error about an unknown name."""
        kind, names = (
            ("function", tuple(FUNCTIONS)) if self.word.text == "(" else ("name", (*self.scope, *RESERVED))
        )
        near = get_close_matches(word.text[:100], names, n=1)
        hint = f"; did you mean {near[0]}?" if near else f". There are: {', '.join(names)[:300]}"
        return ConditionError(f"no {kind} is called {word.text[:40]!r}{hint}", word.column)
