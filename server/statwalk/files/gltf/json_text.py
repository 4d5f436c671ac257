"""Writes the JSON of glTF files, however deep extras nest, and makes numbers like `78.0` integers.

orjson reads values that are nested 1024 deep, but writes only 254.
"""

from __future__ import annotations

from typing import Any

import orjson

FREE = ("extras", "min", "max")
"""members whose numbers stay as they are"""
LARGEST = float(1 << 53)
"""up to here a float holds every whole number"""


def make_whole(root: Any) -> bool:
    """Replaces every whole float below `root` by an int, except in `FREE` members; returns whether there was
    one. JSON has one kind of number, so `78.0` is an integer.
    """
    changed, pending = False, [root]
    while pending:
        entry = pending.pop()
        for key, value in list(enumerate(entry) if isinstance(entry, list) else entry.items()):
            if isinstance(value, float) and value.is_integer() and abs(value) <= LARGEST:
                entry[key] = int(value)
                changed = True
            elif isinstance(value, dict | list) and key not in FREE:
                pending.append(value)
    return changed


def dumps(root: Any) -> bytes:
    """Returns the JSON text of a value, however deep it nests.

    :raises orjson.JSONEncodeError: when the value holds what JSON cannot hold.
    """
    try:
        return orjson.dumps(root)
    except orjson.JSONEncodeError as error:
        if "ecursion" not in str(error):
            raise
        return _deep_text(root)


def _deep_text(root: Any) -> bytes:
    """Returns the JSON text of a deeply nested value, without recursion."""
    text, pending = bytearray(), [root]
    while pending:
        value = pending.pop()
        if isinstance(value, bytes):
            text += value
        elif isinstance(value, dict) and value:
            members = [
                part for key, entry in value.items() for part in (b",", orjson.dumps(key) + b":", entry)
            ]
            pending += [b"}", *reversed(members[1:]), b"{"]
        elif isinstance(value, list) and value:
            items = [part for entry in value for part in (b",", entry)]
            pending += [b"]", *reversed(items[1:]), b"["]
        else:
            text += orjson.dumps(value)
    return bytes(text)
