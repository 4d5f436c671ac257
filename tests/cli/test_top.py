"""`statwalk top` shows what a server says of itself: sums since the last look, a line for each stage."""

import threading
from http.server import BaseHTTPRequestHandler, HTTPServer

import pytest
import typer
from rich.console import Console
from serving import serving
from statwalk.cli import top as module
from statwalk.cli.top import ServerLook, late_quantile, read_samples, server_table, stage_table, top
from statwalk.web.app import create_app

METRICS = """
statwalk_held{{what="stages"}} 1
statwalk_held{{what="actors"}} 2
statwalk_held{{what="viewers"}} 3
statwalk_tick_late_seconds_bucket{{le="0.001"}} {quick}
statwalk_tick_late_seconds_bucket{{le="0.016"}} 100
statwalk_tick_late_seconds_bucket{{le="+Inf"}} 100
statwalk_frames_sent_total{{viewers="2-9"}} {sent}
statwalk_refusals_total{{status="429",limit="requests"}} {refused}
"""


def shown(*tables: object) -> str:
    console = Console(width=120, record=True, file=None, quiet=True)
    with console.capture() as text:
        console.quiet = False
        console.print(*tables)
    return text.get()


def looked(at: float, head: int, **values: int) -> ServerLook:
    stage = {
        "id": "main",
        "clock": "real",
        "paused": False,
        "tick": head,
        "head": head,
        "viewers": 3,
        "pace": 0.4,
    }
    return ServerLook(at, read_samples(METRICS.format(**values)), [{**stage, "actors": [{}, {}]}])


def test_the_table_has_what_changed_since_the_look_before() -> None:
    before = looked(0.0, 100, quick=50, sent=10, refused=4)
    now = looked(2.0, 220, quick=50, sent=370, refused=5)
    lines = shown(server_table(now, before), stage_table(now, before))
    assert "429 (requests): 1" in lines
    assert "360, 0" in lines
    assert "60.0" in lines
    assert "slow, 40%" in lines


def test_the_quantile_is_the_bound_of_its_bucket() -> None:
    samples = looked(0.0, 0, quick=98, sent=0, refused=0).samples
    assert (late_quantile(samples, 0.5), late_quantile(samples, 0.99), late_quantile({}, 0.5)) == (
        0.001,
        0.016,
        0,
    )


def test_a_running_server_is_shown_once(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    with serving(create_app()) as address:
        monkeypatch.setattr(module, "console", Console(width=120))
        top(address, once=True)
    shown = capsys.readouterr().out
    assert "main" in shown
    assert "stages, actors, viewers      1, 1, 0" in shown


@pytest.mark.parametrize("url", ["ftp://127.0.0.1", "http://", "http://a:b"])
def test_what_is_no_address_is_refused(url: str) -> None:
    with pytest.raises(typer.BadParameter):
        top(url, once=True)


def test_a_token_is_sent_as_a_header() -> None:
    """The server that is asked keeps the header that it got."""
    got: list[str | None] = []

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            got.append(self.headers["Authorization"])
            self.send_error(401)

        def log_message(self, *_: object) -> None:
            pass

    with HTTPServer(("127.0.0.1", 0), Handler) as server:
        threading.Thread(target=server.handle_request, daemon=True).start()
        with pytest.raises(OSError, match="401"):
            top(f"http://127.0.0.1:{server.server_port}", once=True, token="abc")
    assert got == ["Bearer abc"]
