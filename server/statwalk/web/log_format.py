"""Formats the log on stderr: a line of text, or a line of JSON, with the id of the request."""

from __future__ import annotations

import logging
from contextvars import ContextVar
from datetime import UTC, datetime
from enum import StrEnum
from typing import Any

import orjson

REQUEST_ID: ContextVar[str] = ContextVar("request_id", default="")
"""the id of the request that the running code answers"""
DETAILS = "details"
"""the attribute of a log record with more members of its JSON line"""


class LogKind(StrEnum):
    """The forms of the log."""

    PLAIN = "plain"
    JSON = "json"


class JsonLine(logging.Formatter):
    """Formats a record as one line of JSON."""

    def format(self, record: logging.LogRecord) -> str:
        """Returns time (UTC), level, logger, message, the request's id, and what the record has besides."""
        members: dict[str, Any] = {
            "time": datetime.fromtimestamp(record.created, UTC).isoformat(timespec="milliseconds"),
            "level": record.levelname.lower(),
            "logger": record.name,
            "message": record.getMessage(),
        }
        if request := REQUEST_ID.get():
            members["request"] = request
        members |= getattr(record, DETAILS, {})
        if record.exc_info:
            members["traceback"] = self.formatException(record.exc_info)
        return orjson.dumps(members, default=repr).decode()


class PlainLine(logging.Formatter):
    """Formats a record as a line of text, and its traceback after it."""

    def format(self, record: logging.LogRecord) -> str:
        """Returns the level, the logger, the request's id and the message."""
        record.request = f" [{request}]" if (request := REQUEST_ID.get()) else ""
        return super().format(record)


def set_up(kind: LogKind) -> None:
    """Sends the log of this process to stderr: warnings and errors; as JSON also a line for each request."""
    handler = logging.StreamHandler()
    handler.setFormatter(
        JsonLine() if kind is LogKind.JSON else PlainLine("%(levelname)s %(name)s%(request)s: %(message)s")
    )
    logging.basicConfig(level=logging.WARNING, handlers=[handler], force=True)
    logging.getLogger("statwalk").setLevel(logging.INFO if kind is LogKind.JSON else logging.WARNING)
