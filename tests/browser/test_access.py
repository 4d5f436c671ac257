"""The page on a server that asks for tokens, and other sites' pages that reach for a server."""

import http.server
import re
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import httpx
import pytest
from browser.chromium import REBOUND
from browser.conftest import Server, until
from live_routes import unguarded
from playwright.sync_api import Page
from serving import serving
from statwalk.services.access.access_file import AccessFile
from statwalk.web.app import create_app

ACCESS = "document.getElementById('access')"
LINK = "<!doctype html><title>mail</title><a id=link href='{0}'>look</a>"


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("access")


@pytest.fixture(scope="module")
def closed(data: Path) -> Iterator[Server]:
    """A server that asks for tokens."""
    with Server(data, "--token") as running:
        yield running


@contextmanager
def site(text: str) -> Iterator[str]:
    """Another site with one page; gives its port."""

    class Site(http.server.BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            self.send_response(200)
            self.send_header("content-type", "text/html")
            self.end_headers()
            self.wfile.write(text.encode())

        def log_message(self, *_: object) -> None:
            pass

    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), Site) as served:
        thread = threading.Thread(target=served.serve_forever, daemon=True)
        thread.start()
        yield str(served.server_port)
        served.shutdown()
        thread.join(5)


def test_the_printed_link_opens_the_page(closed: Server, opened: Callable[[str], Page]) -> None:
    page = opened(closed.link)
    assert page.url == f"{closed.url}/"
    until(page, f"{ACCESS}.hidden")
    assert page.evaluate("document.cookie") == ""  # no script can read it
    page.reload()
    until(page, "window.__viewer?.ready")


def test_a_link_on_another_site_opens_the_page_too(closed: Server, page: Page) -> None:
    """The cookie is strict: the page opens itself once more, and then has it."""
    with site(LINK.format(closed.link)) as port:
        page.goto(f"http://localhost:{port}/")
        page.click("#link")
        page.wait_for_url(f"{closed.url}/")
        until(page, "window.__viewer?.ready")


def test_who_may_only_look_reads_it_and_why_not_more(
    closed: Server, data: Path, page: Page, opened: Callable[[str], Page], allowed: list[str]
) -> None:
    allowed += ["401", "403", "WebSocket connection"]
    file = AccessFile(data)
    opened(f"{closed.url}/?token={file.add('guest', 'view')}")
    until(page, f"{ACCESS}.textContent === 'you may only look'")
    page.keyboard.press("ArrowUp")
    until(page, "document.getElementById('notices').textContent.includes('needs the role drive')")
    file.revoke("guest")
    until(page, f"{ACCESS}.textContent.includes('needs a token')")
    until(page, "document.getElementById('status').dataset.link === 'refused'")
    signed = httpx.get(closed.link)
    page.context.add_cookies(
        [{"name": name, "value": value, "url": closed.url} for name, value in signed.cookies.items()]
    )
    page.evaluate("dispatchEvent(new Event('focus'))")
    until(page, f"{ACCESS}.hidden")


def test_the_list_of_people_shows_what_each_may_do(
    closed: Server, data: Path, page: Page, opened: Callable[[str], Page]
) -> None:
    opened(closed.link)
    other = page.context.browser.new_context().new_page()
    other.goto(f"{closed.url}/?fps=6&token={AccessFile(data).add('Gwen', 'view')}")
    until(other, "window.__viewer?.ready")
    rights = {}
    for looks in (page, other):
        looks.get_by_role("button", name="2 viewers").click()
        until(looks, "document.querySelectorAll('#people li').length === 2")
        rows = looks.locator("#people li").all()
        rights[looks] = {
            re.sub(r"\d+", "1", row.locator("b").inner_text()): row.locator("span").inner_text()
            for row in rows
        }
    other.context.close()
    assert rights[page] == {"viewer 1": "you · may change everything", "Gwen": "may look"}
    assert rights[other] == {"viewer 1": "may change everything", "Gwen": "you · may look"}


def test_a_link_to_a_stage_shows_this_stage(
    closed: Server, page: Page, opened: Callable[[str], Page], allowed: list[str]
) -> None:
    """Also at the address without the stage."""
    allowed += ["403", "WebSocket connection"]
    headers = {"authorization": f"Bearer {closed.link.partition('token=')[2]}"}
    with httpx.Client(base_url=closed.url, headers=headers) as rest:
        new = {"clock": "manual", "actors": [{"machine": "elbow"}]}
        stage = rest.post("/api/stages", json=new).headers["location"]
        link = rest.post(f"{stage}/links", json={"role": "drive"}).json()["url"]
    opened(link)
    until(page, f"{ACCESS}.textContent === 'you may drive this stage'")
    page.goto(f"{closed.url}/")
    until(page, "window.__viewer?.ready")
    until(page, "location.href.endsWith(arg)", stage.rpartition("/")[2])
    until(page, "document.querySelector('#picker select').hidden")


REACH = """<!doctype html><title>evil</title><script>
const server = 'http://SERVER', outcomes = {};
const note = (name, made) =>
  made.then(() => (outcomes[name] = 'reached'), () => (outcomes[name] = 'refused'));
const element = (tag, more) => new Promise((done, failed) => {
  const made = Object.assign(document.createElement(tag), { onload: done, onerror: failed }, more);
  document.head.append(made);
});
const post = { method: 'POST', mode: 'no-cors', headers: { 'content-type': 'text/plain' } };
window.outcomes = outcomes;
window.done = Promise.all([
  note('fetch', fetch(server + '/api/stages').then(r => r.ok ? r.json() : Promise.reject())),
  note('image', element('img', { src: server + '/api/stages/main/actors/1/skeleton.svg' })),
  note('style', element('link', { rel: 'stylesheet', href: server + 'STYLE' })),
  note('socket', new Promise((done, failed) => {
    const socket = new WebSocket(server.replace('http', 'ws') + '/api/stages/main/stream', 'statwalk.v1');
    Object.assign(socket, { onopen: done, onerror: failed });
  })),
  fetch(server + '/api/stages/main/events', { ...post, body: '{"event": "FORWARD"}' }).catch(() => 0),
]);
</script>"""


OUTCOMES = ("fetch", "image", "style", "socket")


def style_of(url: str) -> str:
    return re.findall(r"/assets/[^\"]+\.css", httpx.get(url).text)[0]


def reached(page: Page, address: str, style: str, here: str) -> set[str]:
    """What a page of another site, which calls this computer `here`, gets from the server at `address`."""
    with site(REACH.replace("SERVER", address).replace("STYLE", style)) as port:
        page.goto(f"http://{here}:{port}/")
        page.evaluate("window.done")
        outcomes = page.evaluate("window.outcomes")
    assert outcomes.keys() == set(OUTCOMES)
    return {name for name, outcome in outcomes.items() if outcome == "reached"}


def commands(address: str) -> list[str]:
    return httpx.get(f"http://{address}/api/stages/main/log").text.splitlines()[1:]


@pytest.mark.parametrize(
    ("host", "here"), [("127.0.0.1", "localhost"), ("localhost", "localhost"), (REBOUND, REBOUND)]
)
def test_a_foreign_page_reaches_nothing(
    server: Server, allowed: list[str], page: Page, host: str, here: str
) -> None:
    """The same site with another port, another site, and a name that by now means this computer (DNS
    rebinding).
    """
    allowed.append("")  # the console says what was refused
    style = style_of(server.url)
    before = commands(f"127.0.0.1:{server.port}")
    assert reached(page, f"{host}:{server.port}", style, here) == set()
    assert commands(f"127.0.0.1:{server.port}") == before
    answer = page.goto(f"http://{host}:{server.port}/api/stages")
    assert answer
    assert answer.status == (421 if host == REBOUND else 200)  # 200: as if the user had typed it


def test_control_without_the_guard_a_foreign_page_gets_through(allowed: list[str], page: Page) -> None:
    allowed.append("")
    app: Any = create_app()
    with serving(unguarded(app)) as address:
        _, port = address.split(":")
        style = style_of(f"http://{address}/")
        assert reached(page, address, style, "localhost") == {"image", "style", "socket"}
        answer = page.goto(f"http://{REBOUND}:{port}/api/stages")
        assert answer
        assert answer.status == 200
