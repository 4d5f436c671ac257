"""The form of the machine: the keyboard alone makes and renames its parts; properties are proved there."""

from browser.conftest import Server, until
from browser.edit.conftest import edited, machine
from playwright.sync_api import Page


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
    until(table, "__viewer.stage() !== 'main' && window.least < 30")
    until(table, "__viewer.lanes().some(([, , state]) => state === 'STWK')")
