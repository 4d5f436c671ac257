"""Writes values as YAML: in one line as far as they fit, so that `yaml_text` reads the same back."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence

Value = str | int | float | bool | Sequence["Value"] | Mapping[str, "Value"]
"""text, a number, a truth, a list or a mapping"""
PLAIN = re.compile(r"(?:[\w.]|[+-](?=[\w.]))(?:[\w.+*/<>=()!^%,'-]|[ ](?![ ]|$))*")
"""text that needs no quotes; commas only outside of brackets"""
WIDEST = 110
"""letters of a line, if the value can be written in several"""


class Spread(dict[str, "Value"]):
    """A mapping with a line for each entry, however short it is."""


def text_of(value: str | float | bool, in_brackets: bool = False) -> str:
    """Returns text, a number or a truth as YAML reads it back; `in_brackets`: within `{ }` or `[ ]`."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, int | float):
        return f"{value:.12g}"
    if PLAIN.fullmatch(value) and not (in_brackets and "," in value):
        return value
    return quoted(value)


def quoted(text: str) -> str:
    """Returns the text in double quotes; unprintable characters are escaped."""
    return "".join(
        letter if letter.isprintable() else f"\\U{ord(letter):08x}"
        for letter in json.dumps(text, ensure_ascii=False)
    )


def flow(value: Value, in_brackets: bool = False) -> str:
    """Returns the value in one line: `{clips: {walk: 1.4, run: 3.2}, over: pace}`."""
    if isinstance(value, Mapping):
        return f"{{{', '.join(f'{text_of(key, True)}: {flow(part, True)}' for key, part in value.items())}}}"
    if isinstance(value, str | int | float):
        return text_of(value, in_brackets)
    return f"[{', '.join(flow(part, True) for part in value)}]"


def after_key(value: Value, indent: int, used: int, newline: str) -> str:
    """Returns what follows `key:`: the value in the same line if it fits, else below, each entry in a line of
    its own; text of several lines as a block (`|`).

    `indent`: of the key; `used`: letters of the line with key and colon.
    """
    if isinstance(value, str) and "\n" in value:
        return _text_block(value, indent, newline)
    line = " " + flow(value)
    if isinstance(value, str | int | float) or not value:
        return line
    is_long = used + len(line) > WIDEST or isinstance(value, Spread) or "\\n" in line
    if not is_long and (indent or not _is_section(value)):
        return line
    inner = " " * (indent + 2)
    if isinstance(value, Mapping):
        keys = [f"{inner}{text_of(key)}:" for key in value]
        entries = [
            key + after_key(part, indent + 2, len(key), newline)
            for key, part in zip(keys, value.values(), strict=True)
        ]
        return newline + newline.join(entries)
    return newline + newline.join(f"{inner}- {flow(part)}" for part in value)


def _is_section(value: Sequence[Value] | Mapping[str, Value]) -> bool:
    """Whether each entry gets a line of its own at the top of a file."""
    parts = value.values() if isinstance(value, Mapping) else value
    return not isinstance(value, Mapping) or any(isinstance(part, Mapping) for part in parts)


def _text_block(text: str, indent: int, newline: str) -> str:
    lines = text.removesuffix("\n").split("\n")
    inner = " " * (indent + 2)
    first = next((line for line in lines if line), "")
    head = f"|{2 if first.startswith(' ') else ''}{'' if text.endswith(chr(10)) else '-'}"
    return f" {head}{newline}" + newline.join((inner + line).rstrip(" ") for line in lines)
