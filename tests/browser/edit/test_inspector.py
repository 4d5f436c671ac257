"""The inspector of the selected cell or state: each field makes one edit, and tells at once what is wrong."""

from typing import Any

import httpx
import pytest
from browser.conftest import Server, until
from browser.edit.conftest import CELL, edited, inspect, machine
from playwright.sync_api import Page, Route
from serving import wait_for


def test_a_blend_time_is_one_edit(own: Server, table: Page) -> None:
    inspect(table, CELL)
    table.get_by_label("blend, s").fill("0.45")
    table.keyboard.press("Enter")
    edited(table)
    table.get_by_role("button", name="quintic").click()
    edited(table, 2)
    cell = machine(own)["table"]["WALK"]["LEFT"]
    assert (cell["blend"], cell["curve"], cell["to"]) == (0.45, "quintic", "TLFT")


def test_on_a_phone_the_report_of_a_cell_leads_to_its_inspector(table: Page) -> None:
    table.set_viewport_size({"width": 390, "height": 844})
    table.get_by_role("tab", name="table").click()
    table.locator(CELL).click()
    table.get_by_role("button", name="inspect").click()
    table.locator("#cell h2").filter(has_text="LEFT").wait_for()
    assert table.locator(".cell-field").is_hidden()


def test_a_condition_makes_an_alternative(own: Server, table: Page) -> None:
    """A wrong name is told at the field while it is typed; the right one is kept."""
    inspect(table, CELL)
    field = table.get_by_label("new: if")
    field.fill("lok > 0.5")
    table.locator("#field-new-if-error").filter(has_text="look").wait_for()
    field.fill("look > 0.5")
    table.keyboard.press("Enter")
    edited(table)
    ways = machine(own)["table"]["WALK"]["LEFT"]["alternatives"]
    assert [way["condition"] for way in ways] == ["look > 0.5", ""]
    assert ways[1]["to"] == "TLFT"


def test_an_alternative_has_the_fields_of_a_cell(own: Server, table: Page) -> None:
    """What one alternative gets, the other does not have; blank, it is as the cell says."""
    inspect(table, CELL)
    table.get_by_label("new: if").fill("look > 0.5")
    table.keyboard.press("Enter")
    edited(table)
    first = table.get_by_role("group", name="alternative 1")
    first.get_by_role("button", name="quintic").click()
    edited(table, 2)
    first.get_by_label("enter at").fill("2")
    table.locator("#field-enter-0-error").filter(has_text="a phase from 0 to 1, or match").wait_for()
    first.get_by_label("enter at").fill("0.5")
    table.keyboard.press("Enter")
    edited(table, 3)
    first.get_by_label("action").fill("shout")
    table.keyboard.press("Enter")
    edited(table, 4)
    first, last = machine(own)["table"]["WALK"]["LEFT"]["alternatives"]
    assert (first["curve"], first["enter"], first["action"]) == ("quintic", 0.5, "shout")
    assert (last["curve"], last["enter"], last["action"]) == ("cubic", "match", None)
    assert first["blend"] == last["blend"]


def ways(server: Server, member: str) -> list[tuple[str, Any]]:
    """Where the alternatives of the cell lead, each with a member of it."""
    cell = machine(server)["table"]["WALK"]["LEFT"]
    return [(way["to"], way[member]) for way in cell["alternatives"]]


def test_conditions_are_put_into_another_order_and_deleted(own: Server, table: Page) -> None:
    """The first one has no button that would move it."""
    inspect(table, CELL)
    for times, condition in enumerate(("look > 0.5", "look < 0.2"), 1):
        table.get_by_label("new: if").fill(condition)
        table.keyboard.press("Enter")
        edited(table, times)
    (last, _), (first, _), otherwise = ways(own, "condition")
    assert ways(own, "condition") == [(last, "look < 0.2"), (first, "look > 0.5"), otherwise]
    ones, twos = (table.get_by_role("group", name=f"alternative {number}") for number in (1, 2))
    assert ones.get_by_role("button", name="earlier").count() == 0
    twos.get_by_role("button", name="earlier").click()
    edited(table, 3)
    assert ways(own, "condition") == [(first, "look > 0.5"), (last, "look < 0.2"), otherwise]
    table.get_by_role("button", name=f"delete {last}").click()
    edited(table, 4)
    assert ways(own, "condition") == [(first, "look > 0.5"), otherwise]


def test_chances_have_weights(own: Server, table: Page) -> None:
    """A cell becomes two chances of weight 1; a field changes a weight; chances have no order."""
    inspect(table, CELL)
    table.get_by_role("button", name="add a chance").click()
    edited(table)
    (one, _), (other, _) = made = ways(own, "weight")
    assert made == [("TLFT", 1), (other, 1)]
    table.locator("#cell legend").filter(has_text="by chance").wait_for()
    assert table.locator("#cell").get_by_role("button", name="earlier").count() == 0
    table.get_by_role("group", name="alternative 2").get_by_label("weight").fill("3")
    table.keyboard.press("Enter")
    edited(table, 2)
    assert ways(own, "weight") == [(one, 1), (other, 3)]


def test_a_state_tells_how_alike_left_and_right_move(table: Page) -> None:
    """In a walk the arms and the legs are opposite."""
    inspect(table, "th[data-state=WALK]")
    table.locator("#cell summary").filter(has_text="left and right").click()
    legs = table.locator("#cell .twins tr").filter(has_text="Left.upperleg").first
    assert float(legs.locator("td").first.inner_text()) < 0


def test_a_film_strip_that_comes_late_moves_nothing(table: Page) -> None:
    late: list[Route] = []
    table.route("**/skeleton.svg*", lambda route: late.append(route))
    inspect(table, "th[data-state=WALK]")
    below = table.locator("#cell summary").filter(has_text="left and right")
    before = below.bounding_box()
    strip = table.locator("#cell .strip").first
    assert not strip.evaluate("image => image.complete")
    wait_for(lambda: table.evaluate("true") and late)
    late[0].continue_()
    strip.evaluate("image => image.decode()")
    assert below.bounding_box() == before


def test_a_state_has_another_clip_and_name(own: Server, table: Page) -> None:
    """The clip is chosen by its picture; the inspector follows the new name."""
    table.locator("th[data-state=FLY]").focus()
    table.keyboard.press("Alt+Enter")
    table.locator("#cell .clips summary").click()
    land = table.locator("#cell .clips").get_by_role("button", name="land")
    land.scroll_into_view_if_needed()
    until(table, "document.querySelector('#cell .clips [alt^=land]').naturalWidth > 0")
    land.click()
    edited(table)
    table.locator("#cell").get_by_label("name").fill("GLIDE")
    table.keyboard.press("Enter")
    edited(table, 2)
    table.locator("#cell h2").filter(has_text="GLIDE").wait_for()
    assert {state["name"]: state["motion"] for state in machine(own)["states"]}["GLIDE"] == "land"


def drag(page: Page, part: str, across: float, up: float) -> None:
    """Drags a part of the pad to a place in the pad's room, in shares of the room's width and height."""
    room, start = (page.locator(f".blend-pad {one}").bounding_box() for one in (".room", part))
    assert room is not None
    assert start is not None
    page.mouse.move(start["x"] + start["width"] / 2, start["y"] + start["height"] / 2)
    page.mouse.down()
    page.mouse.move(room["x"] + across * room["width"], room["y"] + (1 - up) * room["height"], steps=4)
    page.mouse.up()


def test_the_mouse_moves_a_blend_over_two_parameters_and_a_clip_of_it(own: Server, table: Page) -> None:
    """A clip that is dragged is one edit; the cross, also on a clip, sets both parameters of the actor."""
    inspect(table, "th[data-state=WALK]")
    table.get_by_label("blend with").select_option("stand")
    edited(table)
    table.get_by_label("over", exact=True).fill("pace, turn")
    table.keyboard.press("Enter")
    edited(table, 2)
    table.locator(".blend-pad").scroll_into_view_if_needed()
    drag(table, "[data-clip=stand] .reach", 0.75, 1)
    edited(table, 3)
    place = {state["name"]: state for state in machine(own)["states"]}["WALK"]["points"]["stand"]
    assert place == pytest.approx([0.75, 1], abs=0.02)
    sliders = table.locator("#parameters")
    for part, pace, turn in ((".cross", 0.25, 0.3), (".ground", 0.3, 0.6)):
        drag(table, part, pace, turn)
        at = pytest.approx({"pace": pace, "turn": turn}, abs=0.02)
        assert {name: float(sliders.get_by_label(name).input_value()) for name in ("pace", "turn")} == at
    actor = f"{own.url}/api/stages/main/actors/1"

    def reached() -> bool:
        found = httpx.get(actor).json()["parameters"]
        return at == {name: found[name] for name in ("pace", "turn")}

    wait_for(reached)
    assert machine(own)["version"] == table.evaluate("window.start") + 3


def test_a_marker_is_added_moved_and_deleted(own: Server, table: Page) -> None:
    """A text that cannot be a marker is refused, and its field says why."""
    inspect(table, "th[data-state=WALK]")
    markers = table.locator("#cell fieldset", has_text="markers")
    markers.get_by_label("new").fill("left-down")
    table.keyboard.press("Enter")
    markers.locator(".field-error").filter(has_text="a name and a phase").wait_for()

    def kept() -> dict[str, float]:
        walk = next(state for state in machine(own)["states"] if state["name"] == "WALK")
        return {marker["name"]: marker["phase"] for marker in walk["markers"]}

    markers.get_by_label("new").fill("left-down 0.25")
    table.keyboard.press("Enter")
    edited(table)
    assert kept() == {"left-down": 0.25}
    for times, (text, left) in enumerate((("0.5", {"left-down": 0.5}), ("", {})), 2):
        markers.get_by_role("group", name="marker left-down").get_by_label("phase").fill(text)
        table.keyboard.press("Enter")
        edited(table, times)
        assert kept() == left


def test_when_a_foot_stands_is_corrected_and_found_again(own: Server, table: Page) -> None:
    inspect(table, "th[data-state=WALK]")
    feet = table.locator("#cell details", has_text="when feet stand in walk")
    feet.locator("summary").click()
    left = feet.get_by_label("left")
    found = left.input_value()
    assert "–" in found

    def stands() -> list[list[float]]:
        clips = httpx.get(f"{own.url}/api/machines/{machine(own)['name']}/feet").json()["clips"]
        walk = next(clip for clip in clips if clip["clip"] == "walk")
        spans: list[list[float]] = walk["feet"][0]["planted"]
        return spans

    left.fill("0.6")
    table.keyboard.press("Enter")
    feet.locator(".field-error").filter(has_text="blank: as found").wait_for()
    left.fill("0–0.5, 0.75–0.8")
    table.keyboard.press("Enter")
    edited(table)
    assert stands() == [[0, 0.5], [0.75, 0.8]]
    left.fill("")
    table.keyboard.press("Enter")
    edited(table, 2)
    wait_for(lambda: left.input_value() == found)
    assert stands() != [[0, 0.5], [0.75, 0.8]]


def test_each_clip_of_a_blend_has_the_contacts_of_its_feet(table: Page) -> None:
    inspect(table, "th[data-state=TLFT]")
    summaries = table.locator("#cell details summary", has_text="when feet stand in")
    summaries.nth(1).wait_for()
    assert summaries.all_inner_texts() == [
        "when feet stand in turn-left",
        "when feet stand in walk-turn-left",
    ]
