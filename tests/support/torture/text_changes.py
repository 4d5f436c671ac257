"""Single changes to a valid text file, a bytearray, in place: numbers, words, pieces and bytes."""

import random
import re
from collections.abc import Sequence

from torture.mutator import Change

NUMBERS = [
    *b"0 1 2 3 4 -1 0.5 1e30 -1e30 1e-30 1e31 nan -1.#IND00 65536 4294967295 1000000000000 0x10 +7".split(),
    *b"1e --1 16 10 inf 1e999 -0 1_0 1e-320 7.5e8 1e9 -1e9 360 90".split(),
    b"1" * 400,
    "٣".encode(),
]
MARKS = [
    b"",
    b"{",
    b"}",
    b'"',
    b";",
    b",",
    b"//",
    b"#",
    b"<",
    b"\0",
    "é".encode(),
    b"\n",
    b"\r",
    b"\t",
    b": ",
]
MARKS += [b"---", b"-", b"x" * 250, "\u2028".encode(), b"\xff"]
NUMBER = re.compile(rb"(?<![\w.-])-?\d[\w.]*")
WHOLE = re.compile(rb"(?<![\w.-])\d+(?![\w.])")
LINE = re.compile(rb"[^\n]*\n")


Span = tuple[int, int]


def span(chance: random.Random, text: bytearray, pattern: re.Pattern[bytes], start: int) -> Span:
    """One of the places where a pattern matches, behind the first bytes; the end if it is nowhere."""
    found = [match.span() for match in pattern.finditer(text, start)]
    return chance.choice(found) if found else (len(text), len(text))


def number_changes(start: int) -> list[Change]:
    """Other numbers, of any size or near the old ones."""

    def replace_number(chance: random.Random, text: bytearray) -> None:
        first, last = span(chance, text, NUMBER, start)
        text[first:last] = chance.choice(NUMBERS)

    def nudge_number(chance: random.Random, text: bytearray) -> None:
        first, last = span(chance, text, WHOLE, start)
        text[first:last] = str(int(text[first:last]) + chance.choice([-2, -1, 1, 2, 1000])).encode()

    return [replace_number, nudge_number]


def piece_changes(piece: re.Pattern[bytes], words: Sequence[bytes], start: int) -> list[Change]:
    """A piece is replaced by a word, removed, or replaced by another piece; a word is put in."""

    def replace_piece(chance: random.Random, text: bytearray) -> None:
        first, last = span(chance, text, piece, start)
        text[first:last] = chance.choice(words)

    def remove_piece(chance: random.Random, text: bytearray) -> None:
        first, last = span(chance, text, piece, start)
        del text[first:last]

    def insert_word(chance: random.Random, text: bytearray) -> None:
        at = span(chance, text, piece, start)[0]
        text[at:at] = b" " + chance.choice(words) + b" "

    def copy_piece(chance: random.Random, text: bytearray) -> None:
        (a, b), (first, last) = span(chance, text, piece, start), span(chance, text, piece, start)
        text[first:last] = text[a:b]

    return [replace_piece, remove_piece, insert_word, copy_piece]


def span_changes(piece: re.Pattern[bytes], start: int) -> list[Change]:
    """Several pieces are copied to another place; a line moves or is copied; a part is cut out."""

    def copy_span(chance: random.Random, text: bytearray) -> None:
        (a, b), (c, d) = span(chance, text, piece, start), span(chance, text, piece, start)
        copied = text[min(a, c) : max(b, d)][: chance.choice([50, 500, 5_000])]
        at = span(chance, text, piece, start)[0]
        text[at:at] = copied

    def move_line(chance: random.Random, text: bytearray) -> None:
        first, last = span(chance, text, LINE, start)
        line = text[first:last]
        if chance.random() < 0.7:
            del text[first:last]
        at = span(chance, text, LINE, start)[0]
        text[at:at] = line

    def cut(chance: random.Random, text: bytearray) -> None:
        first, last = sorted(chance.randrange(start, len(text) + 1) for _ in range(2))
        del text[first : last if chance.random() < 0.7 else len(text)]

    return [copy_span, move_line, cut]


def bad_bytes(chance: random.Random, text: bytearray) -> None:
    for _ in range(chance.choice([1, 20])):
        text[chance.randrange(len(text))] = chance.randrange(256)


def text_changes(piece: re.Pattern[bytes], words: Sequence[bytes], start: int = 0) -> list[Change]:
    """The changes of a format whose pieces (names, numbers, marks) match `piece`; `words` are put into the
    text, and the first `start` bytes stay.
    """
    pieces = piece_changes(piece, [*words, *MARKS, *NUMBERS], start)
    return [*number_changes(start) * 5, *pieces * 2, *span_changes(piece, start), bad_bytes]


def deepen(piece: re.Pattern[bytes], opening: bytes, closing: bytes) -> Change:
    """A change that puts a nest of 3 to 5,000 openings and closings into the text, sometimes one too few."""

    def nest(chance: random.Random, text: bytearray) -> None:
        at = chance.choice([match.start() for match in piece.finditer(text)])
        depth = chance.choice([3, 100, 5_000])
        text[at:at] = opening * depth + closing * chance.choice([depth, depth - 1])

    return nest


def rename(names_in: re.Pattern[bytes], further: Sequence[bytes] = ()) -> Change:
    """A change that gives all mentions of a name another one, which may be in use."""

    def change(chance: random.Random, text: bytearray) -> None:
        names = names_in.findall(text)
        other = chance.choice([*names, *further, b"", b"a b", "é".encode(), b"x" * 250])
        text[:] = text.replace(chance.choice(names), other)

    return change
