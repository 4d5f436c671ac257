"""The table makes structure: the menus of its heads add, rename, move and delete states and events."""

from browser.conftest import Server, until
from browser.edit.conftest import edited, machine
from playwright.sync_api import Page


def states(server: Server) -> list[str]:
    return [state["name"] for state in machine(server)["states"]]


def test_a_state_is_added_by_the_keyboard_alone(own: Server, table: Page) -> None:
    """A name that is there already is told while it is typed; the focus comes back to the table."""
    table.locator("th[data-state=STAT]").focus()
    for key in ("ArrowUp", "Enter", "Enter"):
        table.keyboard.press(key)
    table.keyboard.type("WALK")
    table.locator(".head-menu .field-error").filter(has_text="already").wait_for()
    table.keyboard.press("Control+a")
    table.keyboard.type("RUN")
    table.keyboard.press("Enter")
    edited(table)
    assert states(own)[-1] == "RUN"
    table.locator("th[data-state=RUN]").wait_for()
    until(table, "document.activeElement.matches('#table th')")


def test_a_state_in_use_is_deleted_with_the_cells_that_lead_to_it(
    own: Server, table: Page, allowed: list[str]
) -> None:
    allowed.append("status of 422")
    table.locator("th[data-state=TLFT]").click(position={"x": 20, "y": 8})
    table.get_by_role("menuitem", name="delete").click()
    table.locator(".head-menu .field-error").filter(has_text="WALK/LEFT leads to TLFT").wait_for()
    table.get_by_role("menuitem", name="delete, and").click()
    edited(table)
    assert "TLFT" not in states(own)


def test_an_event_is_renamed_and_moved(own: Server, table: Page) -> None:
    """Its key sends the new name."""
    table.locator("th[data-column=CROUCH]").click()
    table.get_by_role("menuitem", name="rename").click()
    table.keyboard.press("Control+a")
    table.keyboard.type("DUCK")
    table.keyboard.press("Enter")
    edited(table)
    table.locator("th[data-column=DUCK]").click()
    table.get_by_role("menuitem", name="move left").click()
    edited(table, 2)
    made = machine(own)
    assert made["rows"][0][-3:] == ["DUCK", "JUMP", "END"]
    assert made["keys"]["c"]["press"] == "DUCK"
