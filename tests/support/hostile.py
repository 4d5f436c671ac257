"""Bodies that nobody should send; each of them must be a client error."""

DEEPEST = 64

HOSTILE = {
    "NaN": b'{"a": NaN}',
    "Infinity": b"[Infinity]",
    "minus Infinity": b"[-Infinity]",
    "overflow": b"[1e999]",
    "deep arrays": b"[" * 100_000,
    "deep objects": b'{"a":' * 500 + b"1" + b"}" * 500,
    "just too deep": b"[" * (DEEPEST + 1) + b"]" * (DEEPEST + 1),
    "bad UTF-8": b'{"a": "\xff\xfe"}',
    "surrogates as UTF-8": b'"\xed\xa0\x80"',
    "lone surrogate": b'{"event": "\\ud800"}',
    "lone surrogate in a name": b'{"\\udfff": 1}',
    "5000 digits": b"[" + b"9" * 5_000 + b"]",
    "21 digits": b"[-" + b"1" * 21 + b"]",
    "a name twice": b'{"tick": 1, "tick": 2}',
    "byte order mark": b"\xef\xbb\xbf{}",
    "cut short": b'{"a": [1, 2',
    "empty": b"",
    "two values": b"1 2",
    "a control character": b'"\x00"',
    "unclosed string": b'"' + b"[" * 1_000,
}
