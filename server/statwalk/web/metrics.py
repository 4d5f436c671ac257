"""What the server counts, as /metrics shows it; no name that a user has chosen is ever a label."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from prometheus_client import CollectorRegistry, Counter, Gauge, Histogram, generate_latest

from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.stage_host import StageHost
from statwalk.web.connections import Connections

LATE_SECONDS = (0.001, 0.002, 0.004, 0.008, 0.016, 0.033, 0.066, 0.125, 0.25, 0.5, 1.0)
"""the upper bounds of the histogram's buckets"""
METHODS = frozenset({"GET", "HEAD", "POST", "PUT", "PATCH", "DELETE", "OPTIONS"})
CROWDS = ((1, "1"), (9, "2-9"), (99, "10-99"))
"""the labels for stages with at most so many viewers"""
LARGEST_CROWD = "100+"


def crowd(viewers: int) -> str:
    """Returns the label for a stage with so many viewers."""
    return next((label for most, label in CROWDS if viewers <= most), LARGEST_CROWD)


class Metrics:
    """The metrics of one server. Thread-safe."""

    def __init__(self) -> None:
        registry = self._registry = CollectorRegistry()
        self._requests = Counter(
            "statwalk_requests",
            "Answers by method, route and status.",
            ("method", "route", "status"),
            registry=registry,
        )
        self._refusals = Counter(
            "statwalk_refusals",
            "Refusals by status or close code, and by limit.",
            ("status", "limit"),
            registry=registry,
        )
        self._late = Histogram(
            "statwalk_tick_late_seconds",
            "How late ticks of real-time stages are.",
            buckets=LATE_SECONDS,
            registry=registry,
        )
        self._lost = Counter(
            "statwalk_ticks_left_out", "Ticks that were too late to be caught up.", registry=registry
        )
        self._sent = Counter(
            "statwalk_frames_sent",
            "Frames sent, by the stage's number of viewers.",
            ("viewers",),
            registry=registry,
        )
        self._skipped = Counter(
            "statwalk_frames_skipped", "Frames that a newer one replaced.", ("viewers",), registry=registry
        )
        self._closed = Counter(
            "statwalk_connections_closed", "Connections that the server ended.", ("why",), registry=registry
        )
        self._closed_before = (0, 0, 0)
        self._gauges = Gauge("statwalk_held", "What the server holds now.", ("what",), registry=registry)
        self._queues = Gauge("statwalk_waiting", "Lengths of the queues.", ("queue",), registry=registry)

    def count_answer(self, method: str, route: str, status: int) -> None:
        """Counts an answer; `route` is the template of the path."""
        self._requests.labels(method if method in METHODS else "other", route, str(status)).inc()

    def count_refusal(self, status: int, limit: str) -> None:
        """Counts a refusal by its HTTP status or close code; `limit` is empty if no limit was reached."""
        self._refusals.labels(str(status), limit).inc()

    def measure_ticks(self, late: Sequence[float], lost: int) -> None:
        """Counts ticks by the seconds by which they are late, and the ticks that were left out."""
        for seconds in late:
            self._late.observe(seconds)
        if lost:
            self._lost.inc(lost)

    def count_frame(self, viewers: int, skipped: int) -> None:
        """Counts a sent frame and the frames that it replaced, by the number of the stage's viewers."""
        label = crowd(viewers)
        self._sent.labels(label).inc()
        if skipped:
            self._skipped.labels(label).inc(skipped)

    def count_connections(self, connections: Connections) -> None:
        """Counts what the connections of the server came to since the last call."""
        now = (connections.refused, connections.timed_out, connections.closed_idle)
        for kind, number, before in zip(
            ("refused", "too slow", "idle"), now, self._closed_before, strict=True
        ):
            self._closed.labels(kind).inc(number - before)
        self._closed_before = now

    def text(self, stages: Iterable[StageHost], held: dict[str, int], queues: dict[str, int]) -> bytes:
        """Returns all metrics in the text format of Prometheus; `held` and `queues` are true now."""
        hosts = list(stages)
        viewers = sum(host.look(ask.Status()).viewers for host in hosts)
        actors = sum(host.actors for host in hosts)
        for what, number in ({"stages": len(hosts), "actors": actors, "viewers": viewers} | held).items():
            self._gauges.labels(what).set(number)
        for queue, length in queues.items():
            self._queues.labels(queue).set(length)
        return generate_latest(self._registry)
