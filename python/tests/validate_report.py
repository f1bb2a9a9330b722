"""Open reports in Chromium, without a graphics card, and look at what they draw.

    python validate_report.py CHROMIUM REPORT.html [PICTURE.png]

Needs `playwright` and `pillow`. Takes a picture where one is named.
Exits with 1 when a page breaks a promise.
"""

from __future__ import annotations

import io
import sys
import time
from collections.abc import Callable
from pathlib import Path

from PIL import Image
from playwright.sync_api import Browser, Page, sync_playwright

# The browser's own renderer draws what a graphics card would.
ARGUMENTS = ["--no-sandbox", "--enable-unsafe-swiftshader"]
# A page that needs longer hangs, however busy the machine is [s]; no claim on its speed.
READY_WITHIN = 25.0
# A key that has done nothing by then does nothing [s].
ANSWERS_WITHIN = 10.0
# Pictures per second that a replay reaches, or says what it dropped [1/s].
PICTURES_PER_SECOND = 30.0
# Share of the view that pellets cover at least [-].
COVERED = 0.02
SIZES = {"desktop": (1280, 900), "phone": (390, 844)}


class Broken(Exception):
    """A promise that a page breaks."""


def expect(condition: bool, message: str) -> None:
    if not condition:
        raise Broken(message)


def view(page: Page) -> Image.Image:
    picture = page.locator("#view").screenshot()
    return Image.open(io.BytesIO(picture)).convert("HSV")


def becomes(page: Page, happened: Callable[[], bool], message: str) -> None:
    """Waits until something has happened, as long as a busy machine may take."""
    give_up = time.monotonic() + ANSWERS_WITHIN
    while not happened():
        expect(time.monotonic() < give_up, message)
        page.wait_for_timeout(50)


def colored(picture: Image.Image) -> float:
    """Share of the view that has a color: pellets and gates, and neither walls nor ground."""
    saturations = picture.getchannel("S").histogram()
    return sum(saturations[90:]) / sum(saturations)


def opened(browser: Browser, path: Path, size: str, scheme: str) -> tuple[Page, list[str], float]:
    """A page, what the browser complains of, and the time until the replay could be used [s]."""
    width, height = SIZES[size]
    page = browser.new_page(viewport={"width": width, "height": height}, color_scheme=scheme)
    complaints: list[str] = []
    page.on("pageerror", lambda error: complaints.append(str(error)))
    page.on(
        "console",
        lambda message: complaints.append(message.text) if message.type == "error" else None,
    )
    page.on(
        "request",
        lambda request: (
            complaints.append(f"asked for {request.url}") if request.url != path.as_uri() else None
        ),
    )
    began = time.monotonic()
    page.goto(path.as_uri())
    page.wait_for_selector("html[data-state=ready]", timeout=30_000)
    ready = time.monotonic() - began
    expect(ready < READY_WITHIN, f"{size}: it took {ready:.1f} s until the replay could be used")
    return page, complaints, ready


def check_look(page: Page, size: str, scheme: str) -> None:
    share = colored(view(page))
    expect(share > COVERED, f"{size}, {scheme}: pellets cover {share:.1%} of the view")
    paper = page.evaluate("getComputedStyle(document.body).backgroundColor")
    lightness = int(paper.split("(")[1].split(",")[0])
    expect((lightness > 128) == (scheme == "light"), f"{size}: paper of {scheme} is {paper}")
    wider = page.evaluate("document.documentElement.scrollWidth - innerWidth")
    expect(wider <= 0, f"{size}: the page is {wider} px wider than the screen")


def check_keys(page: Page) -> None:
    """Everything can be done without a mouse."""
    clock = page.locator("#clock")
    page.locator("#view").focus()
    before = view(page)
    page.keyboard.press("ArrowLeft")
    becomes(
        page,
        lambda: view(page).tobytes() != before.tobytes(),
        "an arrow key does not turn the view",
    )
    told = clock.text_content()
    page.keyboard.press(".")
    becomes(page, lambda: clock.text_content() != told, "a period does not step")
    page.locator("#scrub").focus()
    page.keyboard.press("Home")
    becomes(
        page,
        lambda: (clock.text_content() or "").startswith("0.000"),
        "Home does not scrub to the start",
    )


def check_play(page: Page) -> str:
    """The replay keeps pace, or says what it dropped."""
    page.locator("#view").focus()
    page.keyboard.press("Space")
    page.wait_for_timeout(4000)
    rate = float(page.evaluate("document.documentElement.dataset.picturesPerSecond"))
    dropped = page.locator("#pace").text_content() or ""
    if page.locator("#play").get_attribute("aria-label") == "Pause":
        page.keyboard.press("Space")
    expect(
        rate >= PICTURES_PER_SECOND or bool(dropped), f"{rate} pictures a second, and not a word"
    )
    return f"{rate:.0f} pictures/s" + (f", {dropped}" if dropped else "")


def check_hits(page: Page) -> None:
    """A press on a hit shows its moment."""
    moment = page.locator(".moment").first
    expect(moment.count() > 0, "no hit is told with its moment")
    when = float(moment.get_attribute("data-time") or "nan")
    moment.press("Enter")
    clock = page.locator("#clock")
    becomes(
        page,
        lambda: abs(float((clock.text_content() or "nan").split()[0]) - when) < 0.001,
        f"the replay does not show the hit at {when} s",
    )


def take(page: Page, picture: Path) -> None:
    """A picture of the replay and the first plots, while the pellets flow."""
    page.set_viewport_size({"width": 1280, "height": 1240})
    page.locator("#scrub").evaluate(
        "scrub => { scrub.value = 0.7 * scrub.max; scrub.dispatchEvent(new Event('input')); }"
    )
    page.wait_for_timeout(500)
    page.screenshot(path=picture)
    page.set_viewport_size({"width": SIZES["desktop"][0], "height": SIZES["desktop"][1]})


def validate(chromium: str, path: Path, picture: Path | None) -> str:
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=ARGUMENTS)
        complaints: list[str] = []
        for size in SIZES:
            for scheme in ("light", "dark"):
                page, heard, _ = opened(browser, path, size, scheme)
                check_look(page, size, scheme)
                complaints += heard
                page.close()
        page, heard, ready = opened(browser, path, "desktop", "light")
        pellets = page.evaluate("document.documentElement.dataset.pellets")
        if picture:
            take(page, picture)
        check_keys(page)
        pace = check_play(page)
        check_hits(page)
        browser.close()
    expect(not complaints + heard, f"the browser complains: {complaints + heard}")
    return (
        f"{path}: {path.stat().st_size} B, {pellets} pellets at first, "
        f"ready after {ready:.1f} s, {pace}"
    )


def main(arguments: list[str]) -> int:
    if len(arguments) not in (2, 3):
        print(__doc__, file=sys.stderr)
        return 1
    chromium, path, *picture = arguments
    try:
        print("ok", validate(chromium, Path(path).resolve(), Path(picture[0]) if picture else None))
    except Exception as error:  # a browser's own complaint is a failure as well
        print(f"BROKEN {path}: {type(error).__name__}: {error}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
