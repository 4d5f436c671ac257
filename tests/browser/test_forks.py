"""Forks stay, and the way back from one."""

import httpx
from browser.conftest import Server, until
from browser.test_time import SCRUB
from playwright.sync_api import Page


def fork(page: Page) -> str:
    """Sends an event to the past; returns the stage that this makes."""
    until(page, "__viewer.tick() > 60 && __viewer.state() === 'STAT'")
    page.evaluate(SCRUB, page.evaluate("__viewer.tick()") - 10)
    until(page, "__viewer.looking() === __viewer.tick()")
    page.keyboard.press("c")
    until(page, "__viewer.stage() !== 'main' && __viewer.ready && __viewer.link() === 'live'")
    return str(page.evaluate("__viewer.stage()"))


def test_back_leads_from_a_fork_to_its_origin_and_forward_to_the_fork(server: Server, viewer: Page) -> None:
    made = fork(viewer)
    viewer.go_back()
    until(viewer, "__viewer.stage() === 'main' && __viewer.ready && __viewer.link() === 'live'")
    assert viewer.url == f"{server.url}/"
    httpx.get(f"{server.url}/api/stages/{made}").raise_for_status()
    viewer.go_forward()
    until(viewer, "__viewer.stage() === arg && __viewer.ready && __viewer.link() === 'live'", made)
