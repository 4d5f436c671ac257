"""The log is one object a line: defects with their traceback, and what cannot be encoded as its repr."""

import json
import logging
import sys

from statwalk.web.log_format import DETAILS, REQUEST_ID, JsonLine, PlainLine


def record(message: str, *arguments: object) -> logging.LogRecord:
    return logging.LogRecord("statwalk.test", logging.ERROR, __file__, 1, message, arguments, None)


def test_a_defect_is_one_line_with_its_traceback() -> None:
    defect = record("a stage %s", "failed")
    try:
        raise ValueError("two\nlines")
    except ValueError:
        defect.exc_info = sys.exc_info()
    line = JsonLine().format(defect)
    assert "\n" not in line
    assert json.loads(line)["message"] == "a stage failed"
    assert "ValueError: two\nlines" in json.loads(line)["traceback"]


def test_what_json_cannot_hold_is_written_as_python_does() -> None:
    odd = record("odd")
    setattr(odd, DETAILS, {"value": {1j}})
    assert json.loads(JsonLine().format(odd))["value"] == "{1j}"


def test_a_plain_line_names_the_request() -> None:
    token = REQUEST_ID.set("7")
    line = PlainLine("%(name)s%(request)s: %(message)s").format(record("it is late"))
    REQUEST_ID.reset(token)
    assert line == "statwalk.test [7]: it is late"
