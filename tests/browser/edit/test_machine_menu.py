"""The menu beside the picker makes machines: copies, from nothing; renames and deletes them."""

import httpx
from browser.conftest import Server, until
from browser.edit.conftest import NAME
from playwright.sync_api import Page


def names(server: Server) -> list[str]:
    return [machine["name"] for machine in httpx.get(f"{server.url}/api/machines").json()]


def test_a_copy_is_made_watched_and_deleted(own: Server, table: Page) -> None:
    table.get_by_role("button", name="machine menu").click()
    table.get_by_role("menuitem", name="copy and change").click()
    table.keyboard.press("Enter")
    until(table, f"document.querySelector('#picker select').value === '{NAME}-copy' && __viewer.ready")
    assert f"{NAME}-copy" in names(own)
    table.get_by_role("button", name="machine menu").click()
    table.get_by_role("menuitem", name="delete").click()
    table.keyboard.press("Enter")
    table.locator("#notices p").filter(has_text="is deleted").wait_for()
    assert f"{NAME}-copy" not in names(own)
