"""What can be hit in the state graph, however small it is drawn: states, and the arrow that is meant."""

from collections.abc import Callable
from typing import Any

import pytest
from browser.conftest import Server, until
from playwright.sync_api import Page

MISSED = """least => [...document.querySelectorAll('#graph .state')].flatMap(state => {
  const { x, y, width, height } = state.querySelector('.box').getBoundingClientRect();
  const [midX, midY, far] = [x + width / 2, y + height / 2, least / 2 - 1];
  return [[0, -far], [0, far], [-far, 0], [far, 0]].flatMap(([right, down]) => {
    const on = document.elementFromPoint(midX + right, midY + down);
    const hit = on?.closest('.state, .halo, .graph-buttons');
    const isOther = hit?.matches('.state, .graph-buttons') && hit !== state;
    return isOther || hit?.dataset.state === state.dataset.state ? [] : [state.dataset.state];
  });
})"""
"""the states that are not hit at half of `least` pixels from their middle, where nothing else is drawn"""
ON_ARROWS = """(() => {
  const lines = [...document.querySelectorAll('#graph .edge .line')].map(line => {
    const [length, onScreen] = [line.getTotalLength(), line.getScreenCTM()];
    const at = part => line.getPointAtLength(part * length).matrixTransform(onScreen);
    return { edge: line.parentNode, points: Array.from({ length: 51 }, (_, i) => at(i / 50)) };
  });
  return lines.flatMap(({ edge, points }) => {
    const [x, y] = [Math.round(points[20].x), Math.round(points[20].y)];
    const isClose = ({ points, edge: other }) =>
      other !== edge && points.some(point => Math.hypot(point.x - x, point.y - y) < 5);
    const isFree = document.elementFromPoint(x, y)?.matches('.reach, .line') && !lines.some(isClose);
    return isFree ? [[x, y, edge.dataset.from, edge.dataset.to]] : [];
  });
})()"""
"""a pixel of each arrow, and the arrow's states, if nothing else is drawn there or within 5 pixels of it"""
CHOSEN = """[...document.querySelectorAll('#graph .edge[aria-pressed=true]')]
    .map(({ dataset }) => [dataset.from, dataset.to])"""
POINTER = {"mouse": {"viewport": {"width": 1024, "height": 700}}}
POINTER["finger"] = {"viewport": {"width": 390, "height": 844}, "has_touch": True, "is_mobile": True}
LEAST = {"mouse": 24, "finger": 44}


@pytest.fixture(params=POINTER)
def pointer(request: pytest.FixtureRequest) -> str:
    named: str = request.param
    return named


@pytest.fixture
def window(pointer: str) -> dict[str, Any]:
    return POINTER[pointer]


@pytest.fixture
def graph(server: Server, opened: Callable[[str], Page]) -> Page:
    page = opened(server.url)
    page.wait_for_selector("#graph .state[data-state=WALK]")
    return page


def test_states_are_hit_that_are_drawn_small(graph: Page, pointer: str) -> None:
    assert graph.evaluate(MISSED, LEAST[pointer]) == []


def test_the_arrow_under_the_pointer_is_chosen_among_arrows_that_lie_close(graph: Page, pointer: str) -> None:
    press = graph.mouse.click if pointer == "mouse" else graph.touchscreen.tap
    count = len(graph.evaluate(ON_ARROWS))
    assert count >= 3
    for number in range(count):
        x, y, *states = graph.evaluate(ON_ARROWS)[number]
        press(x, y)
        until(graph, f"JSON.stringify({CHOSEN}) === JSON.stringify([arg])", states)
