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


def choose(page: Page, state: str, words: str) -> None:
    """Chooses in the menu of a row's head, by the keyboard."""
    page.locator(f"th[data-state='{state}']").focus()
    page.keyboard.press("Enter")
    page.get_by_role("menuitem", name=words).press("Enter")


def test_states_go_into_a_sub_machine_and_out_again(own: Server, table: Page, allowed: list[str]) -> None:
    """The first state makes it; its first state stays while there is another one; the last one ends it."""
    allowed.append("status of 422")
    before = states(own)
    choose(table, "FLY", "put into a sub-machine")
    table.keyboard.type("LAND")
    table.locator(".head-menu .field-error").filter(has_text="no sub-machine").wait_for()
    table.keyboard.press("Control+a")
    table.keyboard.type("AIR")
    table.keyboard.press("Enter")
    edited(table)
    choose(table, "LAND", "put into a sub-machine")
    table.keyboard.type("AIR")
    table.keyboard.press("Enter")
    edited(table, 2)
    assert [name for name in states(own) if "." in name] == ["AIR.FLY", "AIR.LAND"]
    assert machine(own)["table"]["JUMP"]["END"]["to"] == "AIR.FLY"
    choose(table, "AIR.FLY", "take out of AIR")
    table.locator(".head-menu .field-error").filter(has_text="AIR.FLY is the initial state").wait_for()
    table.keyboard.press("Escape")
    for number, name in enumerate(("AIR.LAND", "AIR.FLY"), 3):
        choose(table, name, "take out of AIR")
        edited(table, number)
    assert sorted(states(own)) == sorted(before)
    assert "AIR" not in machine(own)["text"]


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
