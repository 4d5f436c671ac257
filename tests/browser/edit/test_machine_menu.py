"""The menu beside the picker makes machines: copies, from nothing; renames, exports and deletes them. An
exported machine is made again of its file.
"""

from pathlib import Path
from typing import Any
from zipfile import ZipFile

import httpx
from browser.conftest import Server, until
from browser.edit.conftest import NAME
from browser.test_import import drop
from playwright.sync_api import Page


def names(server: Server) -> list[str]:
    return [machine["name"] for machine in httpx.get(f"{server.url}/api/machines").json()]


def choose(page: Page, item: str) -> None:
    page.get_by_role("button", name="machine menu").click()
    page.get_by_role("menuitem", name=item).click()


def test_a_copy_is_made_watched_and_deleted(own: Server, table: Page) -> None:
    choose(table, "copy and change")
    table.keyboard.press("Enter")
    until(table, f"document.querySelector('#picker select').value === '{NAME}-copy' && __viewer.ready")
    assert f"{NAME}-copy" in names(own)
    choose(table, "delete")
    table.keyboard.press("Enter")
    table.locator("#notices p").filter(has_text="is deleted").wait_for()
    assert f"{NAME}-copy" not in names(own)


def test_who_may_not_rename_a_machine_stays_on_its_stage(
    own: Server, table: Page, allowed: list[str]
) -> None:
    """A link led to the stage: the page did not make the stage, so it does not delete the stage."""
    allowed.append("status of 409")
    httpx.post(f"{own.url}/api/machines", json={"name": "linked"}).raise_for_status()
    body = {"actors": [{"machine": "linked"}]}
    made = httpx.post(f"{own.url}/api/stages", json=body, timeout=60).json()["id"]
    table.goto(f"{own.url}/?machine=linked&stage={made}&fps=6")
    until(table, "window.__viewer?.ready && __viewer.stage() === arg", made)
    choose(table, "rename")
    table.get_by_role("textbox", name="new name").fill("free")
    table.keyboard.press("Enter")
    table.locator("#machine-menu [role=alert]").filter(has_text=made).wait_for()
    until(table, "__viewer.link() === 'live' && __viewer.stage() === arg", made)


def test_a_refused_deletion_closes_no_stage(own: Server, table: Page, allowed: list[str]) -> None:
    """The page made its stage, and would delete it as it leaves it; the machine belongs to the server."""
    allowed.append("status of 409")
    table.goto(f"{own.url}/?machine=elbow&fps=6")
    until(table, "window.__viewer?.ready && __viewer.stage() !== 'main'")
    stage = table.evaluate("__viewer.stage()")
    choose(table, "delete")
    table.keyboard.press("Enter")
    table.locator("#machine-menu [role=alert]").filter(has_text="belongs to the server").wait_for()
    assert table.evaluate("__viewer.stage()") == stage
    assert stage in [row["id"] for row in httpx.get(f"{own.url}/api/stages").json()]


def test_a_machine_is_made_from_nothing_renamed_and_exported(own: Server, table: Page) -> None:
    """Typing replaces the proposed name; a name that is taken is refused in the menu."""
    choose(table, "new, from nothing")
    table.get_by_role("textbox", name="name").wait_for()
    table.keyboard.type("fresh")
    table.keyboard.press("Enter")
    until(table, "document.querySelector('#picker select').value === 'fresh' && __viewer.ready")
    choose(table, "rename")
    for name in (NAME, "ripe"):
        table.get_by_role("textbox", name="new name").fill(name)
        table.keyboard.press("Enter")
        if name == NAME:
            table.locator("#machine-menu [role=alert]").filter(has_text=NAME).wait_for()
    until(table, "document.querySelector('#picker select').value === 'ripe' && __viewer.ready")
    assert {"ripe"} == set(names(own)) & {"fresh", "ripe"}
    with table.expect_download() as saving:
        choose(table, "export")
    with ZipFile(saving.value.path()) as exported:
        assert {"machine.yaml", "character.glb"} == set(exported.namelist())
    assert saving.value.suggested_filename == "ripe.zip"


def test_a_machine_from_nothing_has_the_figure_in_the_picture_or_a_skeleton(own: Server, table: Page) -> None:
    motions = {}
    for name, figure in (("plain", "a simple skeleton, without clips"), ("dressed", "the one that you see")):
        choose(table, "new, from nothing")
        table.get_by_role("textbox", name="name").fill(name)
        field = table.get_by_role("combobox", name="figure")
        field.select_option(field.locator("option").filter(has_text=figure).inner_text())
        table.keyboard.press("Enter")
        until(table, "document.querySelector('#picker select').value === arg && __viewer.ready", name)
        motions[name] = httpx.get(f"{own.url}/api/machines/{name}").json()["states"][0]["motion"]
        choose(table, "delete")
        table.keyboard.press("Enter")
        table.locator("#notices p").filter(has_text=f"{name} is deleted").wait_for()
        until(table, "__viewer.stage() === 'main' && __viewer.ready")
    assert motions == {"plain": None, "dressed": "stand"}


def played(server: Server, machine: str) -> dict[str, Any]:
    """What a machine does: its states and its cells, without their lines in the file."""
    view = httpx.get(f"{server.url}/api/machines/{machine}").json()
    rows = {
        state: {event: cell | {"line": None} for event, cell in row.items()}
        for state, row in view["table"].items()
    }
    return {"states": view["states"], "layers": [layer["name"] for layer in view["layers"]], "rows": rows}


def test_an_exported_machine_comes_back_by_dropping(own: Server, table: Page) -> None:
    with table.expect_download() as saving:
        choose(table, "export")
    drop(table, "back.zip", Path(saving.value.path()).read_bytes())
    until(table, "document.querySelector('#picker select').value === 'back' && __viewer.ready")
    assert played(own, "back") == played(own, NAME)
