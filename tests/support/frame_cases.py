"""Frames of RFC 6455, right and wrong ones, and what an echo must answer.

The names follow the chapters of the Autobahn test suite.
"""

from typing import NamedTuple

from raw_frames import BINARY, CLOSE, CONTINUATION, PING, PONG, TEXT, Frame, close, frame
from statwalk.web.settings import LARGEST_MESSAGE_BYTES

PROTOCOL_ERROR, NOT_UTF8, TOO_BIG, NO_CODE = 1002, 1007, 1009, 0
HELLO = "Hello-µ@ßöäüàá-UTF-8!!".encode()


class Case(NamedTuple):
    """What the peer sends, in pieces of so many bytes; which frames come back, and with which code it ends
    (None: nothing is wrong, and the peer closes; 0: without a code).
    """

    sent: bytes
    back: tuple[Frame, ...] = ()
    code: int | None = None
    pieces: int = 0


def echoed(opcode: int, payload: bytes, pieces: int = 0) -> Case:
    return Case(frame(opcode, payload), ((opcode, payload),), pieces=pieces)


def in_parts(*parts: bytes, opcode: int = TEXT) -> bytes:
    last = len(parts) - 1
    return b"".join(
        frame(CONTINUATION if place else opcode, part, fin=place == last) for place, part in enumerate(parts)
    )


CASES: dict[str, Case] = {}

# --- 1 framing: lengths around each form of a length, and bytes that arrive one by one
for opcode, kind in ((TEXT, "text"), (BINARY, "binary")):
    for length in (0, 1, 2, 125, 126, 127, 128, 1_000, 65_535, LARGEST_MESSAGE_BYTES):
        CASES[f"framing: {kind} of {length}"] = echoed(opcode, b"*" * length)
    CASES[f"framing: {kind} in pieces"] = echoed(opcode, b"*" * 65_535, pieces=997)
    CASES[f"framing: {kind} byte by byte"] = echoed(opcode, b"*" * 130, pieces=1)
    CASES[f"framing: two {kind}s at once"] = Case(frame(opcode, b"a") * 2, ((opcode, b"a"),) * 2)

# --- 2 pings and pongs
for payload in (b"", b"Hello, world!", b"\x00\xff\xfe\xfd\xfc\xfb\x00\xff", b"\xfe" * 125):
    CASES[f"ping: {len(payload)} bytes"] = Case(frame(PING, payload), ((PONG, payload),))
    CASES[f"ping: an unasked pong of {len(payload)} bytes"] = Case(
        frame(PONG, payload) + frame(PING, b"p"), ((PONG, b"p"),)
    )
CASES["ping: ten"] = Case(
    b"".join(frame(PING, b"%d" % n) for n in range(10)), tuple((PONG, b"%d" % n) for n in range(10))
)
CASES["ping: ten, byte by byte"] = CASES["ping: ten"]._replace(pieces=1)

# --- 3 reserved bits, 4 reserved opcodes
for reserved in range(1, 8):
    for opcode, kind in ((TEXT, "text"), (BINARY, "binary"), (PING, "ping"), (CLOSE, "close")):
        CASES[f"reserved: bits {reserved} of a {kind}"] = Case(
            frame(opcode, b"" if opcode == CLOSE else b"x", reserved=reserved), code=PROTOCOL_ERROR
        )
CASES["reserved: after a message"] = Case(
    frame(TEXT, b"a") + frame(TEXT, b"b", reserved=2), ((TEXT, b"a"),), PROTOCOL_ERROR
)
for opcode in (3, 4, 5, 6, 7, 11, 12, 13, 14, 15):
    CASES[f"opcode: {opcode} empty"] = Case(frame(opcode), code=PROTOCOL_ERROR)
    CASES[f"opcode: {opcode} with a payload"] = Case(frame(opcode, b"x"), code=PROTOCOL_ERROR)
    CASES[f"opcode: {opcode} after a message, before a ping"] = Case(
        frame(TEXT, b"a") + frame(opcode, b"x") + frame(PING), ((TEXT, b"a"),), PROTOCOL_ERROR
    )

# --- 5 fragments
for opcode, kind in ((PING, "ping"), (PONG, "pong"), (CLOSE, "close")):
    CASES[f"fragments: of a {kind}"] = Case(
        frame(opcode, fin=False) + frame(CONTINUATION), code=PROTOCOL_ERROR
    )
    CASES[f"fragments: a long {kind}"] = Case(frame(opcode, b"\x03\xe8" + b"x" * 124), code=PROTOCOL_ERROR)
for count in (2, 3, 10, 100):
    for opcode, kind in ((TEXT, "text"), (BINARY, "binary")):
        CASES[f"fragments: {kind} in {count}"] = Case(
            in_parts(*[b"part"] * count, opcode=opcode), ((opcode, b"part" * count),)
        )
CASES["fragments: empty ones"] = Case(in_parts(b"", b"", b""), ((TEXT, b""),))
CASES["fragments: one that is empty"] = Case(in_parts(b"a", b"", b"b"), ((TEXT, b"ab"),))
CASES["fragments: byte by byte"] = Case(in_parts(b"one", b"two"), ((TEXT, b"onetwo"),), pieces=1)
BETWEEN = frame(TEXT, b"1", fin=False) + frame(PING, b"p") + frame(CONTINUATION, b"2")
CASES["fragments: a ping between them"] = Case(BETWEEN, ((PONG, b"p"), (TEXT, b"12")))
CASES["fragments: a pong between them"] = Case(
    frame(TEXT, b"1", fin=False) + frame(PONG, b"p") + frame(CONTINUATION, b"2"), ((TEXT, b"12"),)
)
CASES["fragments: pings between three"] = Case(
    frame(TEXT, b"1", fin=False)
    + frame(PING, b"a")
    + frame(CONTINUATION, b"2", fin=False)
    + frame(PING, b"b")
    + frame(CONTINUATION, b"3"),
    ((PONG, b"a"), (PONG, b"b"), (TEXT, b"123")),
)
# the standard would let it close in peace; websockets says that it takes the cut message for an error
CASES["fragments: a close between them"] = Case(
    frame(TEXT, b"1", fin=False) + close(1000), code=PROTOCOL_ERROR
)
for fin in (True, False):
    CASES[f"fragments: a continuation of nothing, fin {fin}"] = Case(
        frame(CONTINUATION, b"x", fin=fin), code=PROTOCOL_ERROR
    )
    CASES[f"fragments: a continuation after the end, fin {fin}"] = Case(
        in_parts(b"a", b"b") + frame(CONTINUATION, b"x", fin=fin), ((TEXT, b"ab"),), PROTOCOL_ERROR
    )
for opcode, kind in ((TEXT, "text"), (BINARY, "binary")):
    for fin in (True, False):
        CASES[f"fragments: a new {kind} within a text, fin {fin}"] = Case(
            frame(TEXT, b"a", fin=False) + frame(opcode, b"b", fin=fin), code=PROTOCOL_ERROR
        )

# --- 6 UTF-8
VALID = [
    HELLO,
    b"\x00",
    b"\x7f",
    b"\xc2\x80",
    b"\xdf\xbf",
    b"\xe0\xa0\x80",
    b"\xed\x9f\xbf",
    b"\xee\x80\x80",
    b"\xef\xbf\xbd",
    b"\xef\xbf\xbe",
    b"\xef\xbf\xbf",
    b"\xef\xbb\xbf",
    b"\xf0\x90\x80\x80",
    b"\xf0\x9f\x98\x80",
    b"\xf4\x8f\xbf\xbf",
    "κόσμε".encode(),
]
INVALID = {
    "a continuation byte": b"\x80",
    "the last continuation byte": b"\xbf",
    "six continuation bytes": b"\x80\xbf\x80\xbf\x80\xbf",
    "a lone start of two": b"\xc2",
    "a start of two and a space": b"\xc2 ",
    "a start of three cut short": b"\xe2\x82",
    "a start of four cut short": b"\xf0\x9f\x98",
    "two bytes for NUL": b"\xc0\x80",
    "two bytes for a slash": b"\xc0\xaf",
    "three bytes for a slash": b"\xe0\x80\xaf",
    "four bytes for a slash": b"\xf0\x80\x80\xaf",
    "five bytes for a slash": b"\xf8\x80\x80\x80\xaf",
    "six bytes for a slash": b"\xfc\x80\x80\x80\x80\xaf",
    "the longest short form of two": b"\xc1\xbf",
    "the longest short form of three": b"\xe0\x9f\xbf",
    "the longest short form of four": b"\xf0\x8f\xbf\xbf",
    "the first surrogate": b"\xed\xa0\x80",
    "the last surrogate": b"\xed\xbf\xbf",
    "a pair of surrogates": b"\xed\xa0\x80\xed\xb0\x80",
    "above the last code point": b"\xf4\x90\x80\x80",
    "five bytes": b"\xf8\x88\x80\x80\x80",
    "six bytes": b"\xfc\x84\x80\x80\x80\x80",
    "FE": b"\xfe",
    "FF": b"\xff",
    "FE FE FF FF": b"\xfe\xfe\xff\xff",
    "the suite's own": "κόσμε".encode() + b"\xed\xa0\x80edited",
}
for text in VALID:
    CASES[f"utf-8: {text.hex()[:20]}"] = echoed(TEXT, text)
    CASES[f"utf-8: {text.hex()[:20]} in fragments"] = Case(
        in_parts(*(bytes([byte]) for byte in text), b""), ((TEXT, text),)
    )
for name, text in INVALID.items():
    CASES[f"no utf-8: {name}"] = Case(frame(TEXT, text), code=NOT_UTF8)
    CASES[f"no utf-8: {name}, after others"] = Case(frame(TEXT, b"begin " + text + b" end"), code=NOT_UTF8)
    CASES[f"no utf-8: {name}, in fragments"] = Case(in_parts(b"a", text, b"b"), code=NOT_UTF8)
    CASES[f"no utf-8: {name}, binary"] = echoed(BINARY, text)

# --- 7 close
CASES["close: without a code"] = Case(close(None), code=NO_CODE)
for code in (1000, 1001, 1002, 1003, 1007, 1008, 1009, 1010, 1011, 3000, 3999, 4000, 4999):
    CASES[f"close: {code}"] = Case(close(code), code=code)
for code in (0, 999, 1004, 1005, 1006, 1015, 1016, 1100, 2000, 2999, 5000, 65_535):
    CASES[f"close: {code} is no code"] = Case(close(code), code=PROTOCOL_ERROR)
CASES["close: half a code"] = Case(frame(CLOSE, b"\x03"), code=PROTOCOL_ERROR)
CASES["close: a reason"] = Case(close(1000, HELLO), code=1000)
CASES["close: the longest reason"] = Case(close(1000, b"*" * 123), code=1000)
CASES["close: a reason that is too long"] = Case(close(1000, b"*" * 124), code=PROTOCOL_ERROR)
for name, text in INVALID.items():
    CASES[f"close: a reason with {name}"] = Case(close(1000, text), code=NOT_UTF8)
CASES["close: then a message"] = Case(close(1000) + frame(TEXT, b"late"), code=1000)
CASES["close: then a ping"] = Case(close(1000) + frame(PING, b"late"), code=1000)
CASES["close: twice"] = Case(close(1000) * 2, code=1000)

# --- masks and lengths
for opcode, kind in ((TEXT, "text"), (PING, "ping"), (CLOSE, "close")):
    CASES[f"mask: a {kind} without"] = Case(frame(opcode, masked=False), code=PROTOCOL_ERROR)
for wide in (2, 8):
    CASES[f"length: {wide} bytes for a ping"] = Case(
        frame(PING, b"x" * 126, length_bytes=wide), code=PROTOCOL_ERROR
    )
for name, length in {"one more": LARGEST_MESSAGE_BYTES + 1, "4 GiB": 1 << 32, "exabytes": 1 << 62}.items():
    CASES[f"length: {name} than may be"] = Case(
        frame(TEXT, b"x", length=length, length_bytes=8), code=TOO_BIG
    )
CASES["length: too much in fragments"] = Case(
    in_parts(b"*" * LARGEST_MESSAGE_BYTES, b"*", opcode=BINARY), code=TOO_BIG
)
