"""The text of a DirectX .x file: its header, and the text without comments."""

from __future__ import annotations

import re

from statwalk.errors import TextError

MAGIC = b"xof "
HEADER_BYTES = 16
VERSIONS = (b"0302", b"0303")
FORMATS = {b"bin ": "binary", b"tzip": "compressed", b"bzip": "compressed binary"}
_COMMENT = re.compile(r'("[^"\n]*")|//[^\n]*|#(?<![^\s;,{}]#)[^\n]*')
_NO_NUMBER = re.compile(r"[-+]?\d\.\d*#(?:IND|QNAN|SNAN|INF)\w*", re.IGNORECASE)
NO_NUMBER_NOTE = "numbers like 1.#IND, which an exporter writes for a failed computation, count as 0"


def is_directx(start: bytes) -> bool:
    """Returns whether a file with these first bytes claims to be a .x file."""
    return start.removeprefix(b"\xef\xbb\xbf").startswith(MAGIC)


def text_after_header(data: bytes, notes: list[str]) -> str:
    """Returns the text after the header, without comments; each line keeps its number.

    :raises TextError: when the header is wrong, or the file is binary or compressed.
    """
    data = data.removeprefix(b"\xef\xbb\xbf")
    header = data[:HEADER_BYTES]
    if len(header) < HEADER_BYTES or not is_directx(header):
        raise TextError("a .x file begins with a header like: xof 0303txt 0032", place="line 1")
    version, form, size = header[4:8], header[8:12], header[12:16]
    if form in FORMATS:
        raise TextError(
            f"this .x file is {FORMATS[form]}; statwalk reads .x files in text form: save it again as text "
            "(xof 0303txt 0032) in the program that wrote it",
            place="line 1",
        )
    if version not in VERSIONS or form != b"txt " or size not in (b"0032", b"0064"):
        shown = header.decode("latin-1")
        raise TextError(
            f"the header should read xof 0303txt 0032 or xof 0302txt 0032, not {shown!r}", place="line 1"
        )
    text = _decoded(data[HEADER_BYTES:]).replace("\r\n", "\n").replace("\r", "\n")
    if "#" in text:
        text, count = _NO_NUMBER.subn("0", text)
        if count:
            notes.append(NO_NUMBER_NOTE)
    return _COMMENT.sub(r"\1", text) if "//" in text or "#" in text else text


def _decoded(data: bytes) -> str:
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError:
        return data.decode("latin-1")
