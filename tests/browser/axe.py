"""What makes a page hard to read or to hit: axe's findings, and controls that are too small."""

from typing import Literal

from paths import ROOT
from playwright.sync_api import Page, ViewportSize

AXE = ROOT / "static" / "node_modules" / "axe-core" / "axe.min.js"
VIOLATIONS = """async rules => {
  const { violations } = await axe.run(document, { resultTypes: ['violations'], ...rules });
  return violations.flatMap(({ id, nodes }) =>
    nodes.map(({ target, failureSummary }) => `${id}: ${target.join(' ')}: ${failureSummary}`));
}"""
CONTROLS = (
    "button, a[href], input, select, textarea, summary, [role=option], [role=menuitem], #table td, "
    "#table th[tabindex]"
)
SMALL = """([controls, least]) => [...document.querySelectorAll(controls)]
  .filter(shown => shown.checkVisibility({ visibilityProperty: true }))
  .map(shown => [shown, shown.getBoundingClientRect()])
  .filter(([, { width, height }]) => Math.min(width, height) < least - 0.5)
  .map(([{ outerHTML }, { width, height }]) => `${width} x ${height}: ${outerHTML.slice(0, 99)}`)"""
POINT_WITH = """([from, to]) => [...document.styleSheets]
  .flatMap(sheet => [...sheet.cssRules])
  .filter(rule => rule.media?.mediaText.includes(from))
  .forEach(rule => (rule.media.mediaText = rule.media.mediaText.replace(from, to)))"""
STILL = """() => {
  const still = new CSSStyleSheet();
  still.replaceSync('* { transition: none !important; animation: none !important }');
  document.adoptedStyleSheets = [still];
}"""
TWO_FRAMES = "async () => { for (const _ of 'ab') await new Promise(requestAnimationFrame); }"
FINGER, ALWAYS = "(pointer: coarse)", "(min-width: 1px)"

LARGE: ViewportSize = {"width": 1440, "height": 900}
"""a window in which all panels are seen, and cells have room for fingers"""


def begin(page: Page) -> None:
    """Gives an open page what `faults` needs."""
    page.evaluate(AXE.read_text())
    page.evaluate(STILL)


def looked_at(page: Page, theme: Literal["light", "dark"], look: str, arg: object) -> list[str]:
    """Returns what `look` finds once the page shows this theme."""
    page.emulate_media(color_scheme=theme)
    page.evaluate(TWO_FRAMES)
    found: list[str] = page.evaluate(look, arg)
    return found


def unreadable(page: Page) -> list[str]:
    """Returns what axe finds, of the light theme only its colours."""
    found = looked_at(page, "light", VIOLATIONS, {"runOnly": ["color-contrast"]})
    return found + looked_at(page, "dark", VIOLATIONS, {})


def small_for_a_finger(page: Page) -> list[str]:
    """Returns the controls that a finger misses, on a page that is touched."""
    return looked_at(page, "dark", SMALL, [CONTROLS, 44])


def faults(page: Page) -> list[str]:
    """Returns what axe finds, and what is hard to hit with a mouse or a finger, on a page with a mouse."""
    found = unreadable(page) + page.evaluate(SMALL, [CONTROLS, 24])
    page.evaluate(POINT_WITH, [FINGER, ALWAYS])
    found += small_for_a_finger(page)
    page.evaluate(POINT_WITH, [ALWAYS, FINGER])
    return found
