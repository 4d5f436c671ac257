"""The form of the machine: the keyboard alone makes and renames its parts; properties are proved there."""

import pytest
from browser.conftest import Server, until
from browser.edit.conftest import edited, machine
from playwright.sync_api import Locator, Page


def test_a_parameter_and_a_sense_of_it_by_the_keyboard_alone(own: Server, table: Page) -> None:
    """The sense follows the parameter's new name, and the keyboard stays at the renamed entry."""
    table.get_by_role("button", name="inspect").press("Enter")
    table.get_by_role("tab", name="cell", exact=True).press("ArrowRight")
    parameters, senses = (table.locator(f"[data-section={name}]") for name in ("parameters", "senses"))
    parameters.locator("summary").press("Enter")
    parameters.get_by_label("new").fill("pace")
    table.keyboard.press("Enter")
    edited(table, 1)
    parameters.get_by_label("name").last.fill("stride")
    table.keyboard.press("Enter")
    edited(table, 2)
    until(table, "document.activeElement.value === 'stride'")
    senses.locator("summary").press("Enter")
    senses.get_by_label("new").fill("HURRY: stride > 0.5")
    table.keyboard.press("Enter")
    edited(table, 3)
    made = machine(own)
    assert made["parameters"][-1]["name"] == "stride"
    assert made["senses"] == {"HURRY": {"when": "stride > 0.5", "release": ""}}


def test_a_key_is_made_by_the_form_and_found_from_the_help(own: Server, table: Page) -> None:
    """The new key acts at once, and with another name."""
    table.keyboard.press("?")
    table.get_by_role("button", name="change the machine’s keys").click()
    keys = table.locator("[data-section=keys]")
    keys.locator("summary").click()
    keys.get_by_label("new").fill("k: FORWARD")
    table.keyboard.press("Enter")
    edited(table, 1)
    made = keys.get_by_role("group", name="k", exact=True)
    made.get_by_label("name").fill("z")
    table.keyboard.press("Enter")
    edited(table, 2)
    assert machine(own)["keys"]["z"] == {"press": "FORWARD", "hold": False, "release": None, "change": {}}
    table.locator("#stage-view").click(position={"x": 20, "y": 200})
    table.keyboard.press("z")
    until(table, "__viewer.lanes().some(([, , state]) => state === 'STWK')")


LOOKED = """window.least = Infinity;
(function look() {
  least = Math.min(least, __viewer.looking() ?? Infinity);
  requestAnimationFrame(look);
})()"""
"""notes the first tick that the page looks at"""


def test_what_refutes_a_property_is_played_on_a_stage(table: Page, allowed: list[str]) -> None:
    """The walker starts to walk, which the typed property forbids; the page shows it from its first ticks."""
    allowed.append("status of 422")
    table.get_by_role("button", name="inspect").click()
    table.get_by_role("tab", name="machine").click()
    properties = table.locator("[data-section=properties]")
    properties.locator("summary").click()
    properties.get_by_label("new").fill("never STAT -> STWK")
    table.evaluate(LOOKED)
    properties.get_by_role("button", name="play what refutes it").click()
    until(table, "__viewer.stage() !== 'main' && window.least <= 30")
    until(table, "__viewer.lanes().some(([, , state]) => state === 'STWK')")


def open_section(page: Page, name: str) -> Locator:
    """Opens the machine's form, and a section of it."""
    page.get_by_role("button", name="inspect").click()
    page.get_by_role("tab", name="machine").click()
    section = page.locator(f"[data-section='{name}']")
    section.locator("summary").click()
    return section


def test_a_layer_is_added_renamed_moved_and_deleted(own: Server, table: Page) -> None:
    layers = open_section(table, "layers")
    layers.get_by_label("new").fill("arms")
    table.keyboard.press("Enter")
    edited(table, 1)
    arms = layers.get_by_role("group", name="arms")
    arms.get_by_label("joints").fill("Left.shoulder, Right.shoulder")
    table.keyboard.press("Enter")
    edited(table, 2)
    arms.get_by_label("mode").select_option("additive")
    edited(table, 3)
    arms.get_by_label("name").fill("limbs")
    table.keyboard.press("Enter")
    edited(table, 4)
    layers.get_by_role("button", name="move limbs up").click()
    edited(table, 5)
    made = machine(own)["layers"]
    assert [layer["name"] for layer in made] == ["base", "limbs", "head"]
    assert (made[1]["mask"], made[1]["mode"]) == (["Left.shoulder", "Right.shoulder"], "additive")
    table.get_by_role("tab", name="limbs").wait_for()
    layers.get_by_role("button", name="delete limbs").click()
    edited(table, 6)
    assert [layer["name"] for layer in machine(own)["layers"]] == ["base", "head"]
    table.get_by_role("tab", name="limbs").wait_for(state="detached")


@pytest.mark.parametrize(
    ("name", "first", "second"),
    [("parameters", "pace", "lean"), ("senses", "NEAR: look > 0.5", "FAR: look < 0.1")],
)
def test_a_parameter_or_a_sense_is_added_renamed_moved_and_deleted(
    own: Server, table: Page, name: str, first: str, second: str
) -> None:
    section = open_section(table, name)
    one, two = (text.partition(":")[0] for text in (first, second))
    before = list(entries(own, name))
    for times, text in enumerate((first, second), 1):
        section.get_by_label("new").fill(text)
        table.keyboard.press("Enter")
        edited(table, times)
    section.get_by_role("button", name=f"move {two} up").click()
    edited(table, 3)
    assert entries(own, name) == [*before, two, one]
    section.get_by_role("group", name=two).get_by_label("name").fill(f"{two}2")
    table.keyboard.press("Enter")
    edited(table, 4)
    assert entries(own, name) == [*before, f"{two}2", one]
    section.get_by_role("button", name=f"delete {one}").click()
    edited(table, 5)
    assert entries(own, name) == [*before, f"{two}2"]
    section.get_by_role("group", name=one, exact=True).wait_for(state="detached")


def entries(server: Server, section: str) -> list[str]:
    """Lists the names in a section of the file, in order; three entries of a point are one name."""
    found = machine(server)[section]
    if section == "senses":
        return list(found)
    return list(dict.fromkeys(entry["vector"] or entry["name"] for entry in found))


def test_a_kept_property_is_shown_proved_edited_and_deleted(own: Server, table: Page) -> None:
    properties = open_section(table, "properties")
    count, before = properties.locator("summary output"), machine(own)["properties"]
    count.filter(has_text=f"{len(before)} of {len(before)} proved").wait_for()
    properties.get_by_label("new").fill("never STAT -> FLY")
    table.keyboard.press("Enter")
    edited(table)
    kept = properties.get_by_role("group", name="never STAT -> FLY")
    kept.locator(".verdict").filter(has_text="proved").wait_for()
    count.filter(has_text=f"{len(before) + 1} of {len(before) + 1} proved").wait_for()
    kept.get_by_role("textbox").fill("never LAND -> FLY")
    table.keyboard.press("Enter")
    edited(table, 2)
    assert machine(own)["properties"] == [*before, "never LAND -> FLY"]
    properties.get_by_role("button", name="delete never LAND -> FLY").click()
    edited(table, 3)
    assert machine(own)["properties"] == before


def test_a_default_column_is_made_and_taken_away(own: Server, table: Page) -> None:
    rows = open_section(table, "rows and columns")
    rows.get_by_label("new").select_option("every state, CROUCH")
    for target, count, where in (("CRCH", "1", "CRCH"), ("", "0", None)):
        table.locator("#cell h2").filter(has_text="every state CROUCH").wait_for()
        table.locator("#cell").get_by_label("next state").select_option(target)
        table.get_by_role("tab", name="machine").click()
        rows.locator("output").filter(has_text=count).wait_for()
        cell = machine(own)["table"]["FLY"].get("CROUCH")
        assert (cell and cell["to"]) == where
        if count == "1":
            rows.get_by_role("button", name="every state, CROUCH").click()


def test_the_palette_leads_from_a_field_to_another_section(table: Page) -> None:
    open_section(table, "about").get_by_label("title").focus()
    table.keyboard.press("Control+k")
    table.keyboard.type("proof")
    table.keyboard.press("Enter")
    properties = table.locator("[data-section=properties]")
    until(table, "document.activeElement.parentElement.dataset.section === 'properties'")
    properties.get_by_label("new").wait_for()
