#!/usr/bin/python3
"""Measures the explorer's page in a headless Chromium: harness/explore/measure.py MWT

Prints how long a triangulation takes while a point is dragged among 1,000, and how long frames take while 100,000 points with
greedy and the proved optimum are moved and zoomed.
"""
import pathlib
import statistics
import sys
import time

sys.path.insert(1, str(pathlib.Path(__file__).resolve().parents[2] / "plots"))  # behind this folder
import browser  # noqa: E402  (in plots/)
from page_test import Explorer  # noqa: E402  (beside this file)

FRAMES = 200


def wait_for(page, expression):
    while not page.value(f"window.explorer && ({expression})"):
        time.sleep(0.05)


def wait_until_complete(page):
    wait_for(page, "explorer.solving.isIdle && explorer.shown && explorer.shown.isComplete")


def described(times):
    ordered = sorted(times)
    return f"median {statistics.median(ordered):.0f} ms, 95% below {ordered[len(ordered) * 95 // 100]:.0f} ms, {len(ordered)} measured"


def drag(page):
    """Drags a point in 100 steps, 30 ms apart, as a hand does."""
    left, top = page.value(
        "(() => { const box = document.getElementById('picture').getBoundingClientRect(); const c ="
        " explorer.points.coordinates; const [x, y] = explorer.picture.toScreen(c[1000], c[1001]);"
        " return [box.left + x, box.top + y]; })()"
    )
    page.dispatch("dispatchMouseEvent", type="mousePressed", x=left, y=top, button="left", clickCount=1)
    page.value("explorer.solving.latency.length = 0")
    for step in range(100):
        page.dispatch("dispatchMouseEvent", type="mouseMoved", x=left + step / 2, y=top + step / 3, button="left")
        time.sleep(0.03)
    page.dispatch("dispatchMouseEvent", type="mouseReleased", x=left + 50, y=top + 33, button="left", clickCount=1)
    wait_until_complete(page)
    return page.value("explorer.solving.latency")


def frames_while(page, change):
    """Milliseconds between frames while each of them changes the view."""
    page.run(
        f"window.frames_ended = false; const times = []; const step = (now) => {{ times.push(now); const k = times.length; {change};"
        f" if (k < {FRAMES}) requestAnimationFrame(step); else {{ window.frame_times = times; window.frames_ended = true; }} }};"
        " requestAnimationFrame(step);"
    )
    wait_for(page, "window.frames_ended")
    times = page.value("window.frame_times")
    return [after - before for before, after in zip(times, times[1:])]


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: measure.py MWT")
    explorer = Explorer()
    try:
        with browser.Browser(1440, 900) as page:
            page.open(f"{explorer.address}#family=uniform&n=1000&seed=1&first=greedy&second=optimum&time_limit=10")
            wait_until_complete(page)
            print("dragging one of 1,000 points, until greedy is drawn:", described(drag(page)))
            page.open(f"{explorer.address}#family=uniform&n=100000&seed=1&first=greedy&second=optimum&time_limit=60")
            wait_until_complete(page)
            time.sleep(2)
            print("moving 100,000 points, from frame to frame:", described(frames_while(page, "explorer.picture.pan(3, 2)")))
            zoom = "explorer.picture.zoom(k < 100 ? 1.04 : 1 / 1.04)"
            print("zooming them, from frame to frame:", described(frames_while(page, zoom)))
    finally:
        explorer.stop()


if __name__ == "__main__":
    main()
