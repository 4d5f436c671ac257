"""The table makes structure: the menus of its heads add, rename, move and delete states and events."""

import pytest
from browser.conftest import Server, passing, until
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
    choose_at(page, f"th[data-state='{state}']", words)


def choose_at(page: Page, head: str, words: str) -> None:
    page.locator(head).first.focus()
    page.keyboard.press("Enter")
    page.get_by_role("menuitem", name=words, exact=True).press("Enter")


def test_states_go_into_a_sub_machine_and_out_again(own: Server, table: Page, allowed: list[str]) -> None:
    """The first state makes it; its first state stays while there is another one; the last one ends it."""
    allowed.append("status of 422")
    before = states(own)
    choose(table, "FLY", "put into a sub-machine …")
    table.keyboard.type("LAND")
    table.locator(".head-menu .field-error").filter(has_text="no sub-machine").wait_for()
    table.keyboard.press("Control+a")
    table.keyboard.type("AIR")
    table.keyboard.press("Enter")
    edited(table)
    choose(table, "LAND", "put into a sub-machine …")
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


def test_a_state_moves_up_and_down(own: Server, table: Page) -> None:
    """The row moves in the table and in the file; the first row can only move down."""
    rows = "[...document.querySelectorAll('#table tbody th')].map(th => th.dataset.state)"
    before = states(own)
    choose(table, "WALK", "move up")
    edited(table)
    assert states(own)[:3] == ["STAT", "WALK", "STWK"]
    choose(table, "STAT", "move down")
    edited(table, 2)
    assert states(own) == ["WALK", "STAT", "STWK", *before[3:]]
    assert table.evaluate(rows) == states(own)
    table.locator("th[data-state=WALK]").focus()
    table.keyboard.press("Enter")
    assert table.get_by_role("menuitem", name="move up", exact=True).is_disabled()


def test_an_event_in_use_is_deleted_with_its_key(own: Server, table: Page, allowed: list[str]) -> None:
    """First the menu says what would be lost."""
    allowed.append("status of 422")
    choose_at(table, "th[data-column=JUMP]", "delete")
    table.locator(".head-menu .field-error").filter(has_text="JUMP").wait_for()
    table.get_by_role("menuitem", name="delete, and").press("Enter")
    edited(table)
    made = machine(own)
    assert "JUMP" not in [*made["events"], *made["rows"][0]]
    assert "Space" not in made["keys"]
    table.locator("th[data-column=JUMP]").wait_for(state="detached")


@pytest.mark.parametrize(
    ("head", "words", "name", "filled"),
    [
        ("th[data-state=FLY]", "default of this row …", "FLY every event", {"FLY": 8, "LAND": 1}),
        ("th.corner", "default of all cells …", "every state every event", {"FLY": 8, "LAND": 8}),
    ],
)
def test_a_default_fills_blank_cells(
    own: Server, table: Page, head: str, words: str, name: str, filled: dict[str, int]
) -> None:
    """One of a row fills it, one of all cells fills all; what is written stays."""
    choose_at(table, head, words)
    table.locator("#cell h2").filter(has_text=name).wait_for()
    table.locator("#cell").get_by_label("next state").select_option("CRCH")
    edited(table)
    cells = machine(own)["table"]
    assert {state: len(cells[state]) for state in filled} == filled
    assert cells["FLY"]["END"]["to"] == "LAND"
    assert cells["FLY"]["JUMP"]["to"] == "CRCH"


def test_the_characters_keys_work_after_a_menu_of_the_table(table: Page) -> None:
    """The head keeps the focus, and the keys that it has a use for."""
    table.locator("th[data-column=JUMP]").click()
    table.get_by_role("menuitem").first.wait_for()
    table.keyboard.press("Escape")
    with passing(table, "CRCH"):
        table.keyboard.press("c")
    table.keyboard.press("ArrowLeft")
    until(table, "document.activeElement.dataset.column === 'STOP'")
