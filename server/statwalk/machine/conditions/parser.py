"""From the text of a condition to its program, by precedence (Pratt 1973): the steps come out in postfix order as they are read."""

from __future__ import annotations

from collections.abc import Sequence
from difflib import get_close_matches

from statwalk.machine.conditions.operations import CONSTANTS, FUNCTIONS, LARGEST, OPERATORS
from statwalk.machine.conditions.program import Program, Step
from statwalk.machine.conditions.words import ConditionError, Word, words_of

DEEPEST = 32
COMPARISONS = ("<", "<=", ">", ">=", "==", "!=")
POWER = {"or": 1, "and": 2, **dict.fromkeys(COMPARISONS, 4), "+": 5, "-": 5, "*": 6, "/": 6, "%": 6}
"""how strongly the operators between two values bind"""
NOT_POWER, MINUS_POWER = 3, 7
RESERVED = (*FUNCTIONS, *CONSTANTS, "and", "or", "not")


def parse(text: str, known: Sequence[str]) -> Program:
    """The program of a condition over the names `known`. Raises ConditionError with column and nearest name."""
    parser = Parser(words_of(text), tuple(known))
    parser.value(0, 0)
    if parser.word.kind != "end":
        raise parser.refuse("an operator or the end is wanted here, not")
    return Program(text.strip(), tuple(known), tuple(parser.steps))


class Parser:
    """A place in the words, and the steps that the words before it have become."""

    def __init__(self, words: list[Word], known: tuple[str, ...]) -> None:
        self.words, self.known = words, known
        self.place = 0
        self.steps: list[Step] = []

    @property
    def word(self) -> Word:
        """The word that is read next."""
        return self.words[self.place]

    def next(self) -> Word:
        """Reads a word."""
        word = self.word
        self.place += word.kind != "end"
        return word

    def refuse(self, message: str) -> ConditionError:
        """The error about the word that is read next."""
        return ConditionError(f"{message} {self.word.text[:40]!r}" if self.word.text else f"{message} the end", self.word.column)

    def expect(self, sign: str) -> None:
        """Reads that sign."""
        if self.word.text != sign:
            raise self.refuse(f"{sign!r} is wanted here, not")
        self.next()

    def value(self, power: int, depth: int) -> None:
        """A value, and all that operators which bind more strongly than `power` make of it."""
        if depth > DEEPEST:
            raise self.refuse(f"the condition is more than {DEEPEST} deep here, at")
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
        """A number, a name, a call, what is in brackets, or `not` and `-` with what they are for."""
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
        """A number of at most ±1e300."""
        value = float(word.text)
        if value > LARGEST:
            raise ConditionError(f"{word.text[:40]} is more than {LARGEST:g}", word.column)
        self.steps.append(value)

    def name(self, word: Word, depth: int) -> None:
        """A variable, a constant, or a call."""
        if word.text in self.known and self.word.text != "(":
            self.steps.append(word.text)
        elif word.text in CONSTANTS:
            self.steps.append(float(CONSTANTS[word.text]))
        elif word.text in FUNCTIONS:
            self.call(word, depth)
        else:
            raise self.unknown(word)

    def call(self, word: Word, depth: int) -> None:
        """A function with its arguments."""
        function = FUNCTIONS[word.text]
        self.expect("(")
        for number in range(function.takes):
            if number:
                self.expect(",")
            self.value(0, depth + 1)
        if self.word.text == ",":
            raise ConditionError(f"{word.text} takes {function.takes} value{'s' * (function.takes > 1)}, not more", self.word.column)
        self.expect(")")
        self.steps.append(function)

    def unknown(self, word: Word) -> ConditionError:
        """The error about a name that does not exist."""
        kind, names = ("function", tuple(FUNCTIONS)) if self.word.text == "(" else ("name", (*self.known, *RESERVED))
        near = get_close_matches(word.text[:100], names, n=1)
        hint = f"; did you mean {near[0]}?" if near else f". There are: {', '.join(names)[:300]}"
        return ConditionError(f"no {kind} is called {word.text[:40]!r}{hint}", word.column)
