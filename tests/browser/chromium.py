"""The browser of the tests: which Chromium, and how it is started."""

import ctypes
import shutil
import sys
from collections.abc import Iterator
from contextlib import contextmanager

from playwright.sync_api import Browser, sync_playwright

CHROMIUMS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "microsoft-edge")
REBOUND = "rebound.example"
"""a name that means this computer, for the browser alone"""
UNWANTED = (
    "WebUIOmniboxPopup,WebUIOmniboxAimPopup,HttpsUpgrades,HttpsFirstBalancedModeAutoEnable,PaintHolding,"
    "OptimizationHints,NetworkTimeServiceQuerying,MediaRouter,DestroyProfileOnBrowserClose"
)
"""features of Chromium that are turned off. The first two load the pages of Chromium's own address line for
each window, which takes half as long as a page of ours. The others are from Playwright's list of such
features: Chromium takes the last list alone, which is this one
"""
DROP_FROM_BOUNDING_SET, CAP_SYS_NICE = 24, 23
"""numbers of Linux's prctl"""


def draw_after_others() -> None:
    """Takes from this process's children the right to raise their priority. A Chromium that root starts gives
    its drawing a higher one; without a graphics card its own page and the server then wait for the drawing.
    """
    if sys.platform == "linux":  # who is not root has no such right
        ctypes.CDLL(None).prctl(DROP_FROM_BOUNDING_SET, CAP_SYS_NICE, 0, 0, 0)


@contextmanager
def launched() -> Iterator[Browser]:
    """Chromium: the machine's own, else Playwright's."""
    path = next((found for name in CHROMIUMS if (found := shutil.which(name))), None)
    draw_after_others()
    with sync_playwright() as playwright:
        args = [
            "--enable-unsafe-swiftshader",
            f"--host-resolver-rules=MAP {REBOUND} 127.0.0.1",
            f"--disable-features={UNWANTED}",
        ]
        browser = playwright.chromium.launch(executable_path=path, args=args)
        yield browser
        browser.close()
