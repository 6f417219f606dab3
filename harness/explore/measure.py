#!/usr/bin/python3
"""Measures the explorer's page in a headless Chromium: harness/explore/measure.py MWT [drag] [large] [million]

Prints the processor and the load of the machine, and:
  drag     how long greedy's triangulation, and the proved optimum with alpha, take while a point is dragged among 1,000
  large    how long frames take while 100,000 points with greedy and the proved optimum are moved and zoomed
  million  the same for 1,000,000 points with greedy alone, how long they take to come, also from a file, also on a phone's screen
All three if none is named.
"""
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

sys.path.insert(1, str(pathlib.Path(__file__).resolve().parents[2] / "plots"))  # behind this folder
import browser  # noqa: E402  (in plots/)
from page_test import Explorer, program  # noqa: E402  (beside this file)

FRAMES = 200


def wait_for(page, expression):
    while not page.value(f"window.explorer && ({expression})"):
        time.sleep(0.05)


def wait_until_complete(page):
    wait_for(page, "!explorer.isLoading && explorer.solving.isIdle && explorer.shown && explorer.shown.isComplete && explorer.picture.isSettled")


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
    page.value("explorer.solving.latency.length = explorer.solving.completeLatency.length = 0")
    for step in range(100):
        page.dispatch("dispatchMouseEvent", type="mouseMoved", x=left + step / 2, y=top + step / 3, button="left")
        time.sleep(0.03)
    page.dispatch("dispatchMouseEvent", type="mouseReleased", x=left + 50, y=top + 33, button="left", clickCount=1)
    wait_until_complete(page)
    return page.value("[explorer.solving.latency, explorer.solving.completeLatency]")


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


def measure_dragging(page, explorer):
    page.open(f"{explorer.address}#family=uniform&n=1000&seed=1&first=greedy&second=optimum&time_limit=10")
    wait_until_complete(page)
    first, complete = drag(page)
    print("dragging one of 1,000 points, until greedy is drawn:", described(first))
    print("until the optimum and alpha are, too:", described(complete))


def measure_moving(page, count):
    print(f"moving {count}, from frame to frame:", described(frames_while(page, "explorer.picture.pan(3, 2)")))
    zoom = "explorer.picture.zoom(k < 100 ? 1.04 : 1 / 1.04)"
    print("zooming them, from frame to frame:", described(frames_while(page, zoom)))
    wait_until_complete(page)
    print(f"drawing them anew: {page.value('explorer.picture.drawings.at(-1)'):.0f} ms, in slices between frames")


def measure_large(page, explorer):
    page.open(f"{explorer.address}#family=uniform&n=100000&seed=1&first=greedy&second=optimum&time_limit=60")
    wait_until_complete(page)
    measure_moving(page, "100,000 points")


def times_of(page, view):
    """Seconds, by the page's own clock, until the million points of a view are drawn and until all is there. (The driver of the browser
    takes seconds for each large request that it sees.)"""
    complete = "explorer.solving.isIdle && explorer.shown && explorer.shown.isComplete && explorer.picture.isSettled"
    page.run(
        f"window.times = null; const begin = performance.now(); let drawn = 0; location.hash = {view!r}; const look = () => {{"
        " if (!drawn && explorer.points.size === 1000000 && explorer.picture.isSettled) drawn = performance.now() - begin;"
        f" if (drawn && explorer.shown && explorer.shown.size === 1000000 && {complete}) window.times = [drawn, performance.now() - begin];"
        " else requestAnimationFrame(look); }; look();"
    )
    wait_for(page, "window.times")
    drawn, done = page.value("window.times")
    return f"drawn after {drawn / 1000:.1f} s, with greedy after {done / 1000:.1f} s"


SMALL = "family=uniform&n=10&first=greedy&second=none&optimum=no"
GREEDY = "first=greedy&second=none&optimum=no&time_limit=60"


def measure_million(page, explorer):
    page.open(f"{explorer.address}#{SMALL}")
    wait_until_complete(page)
    print("1,000,000 points of a family:", times_of(page, f"family=uniform&n=1000000&seed=1&{GREEDY}"))
    measure_moving(page, "1,000,000 points")
    memory = page.value("Math.round(performance.memory.usedJSHeapSize / 2 ** 20)")
    print(f"the page's heap: {memory} MiB")


def measure_file():
    """A million points that `mwt explore` is called with, on a phone's screen."""
    with tempfile.TemporaryDirectory() as folder:
        points = pathlib.Path(folder) / "million.csv"
        subprocess.run([program(), "generate", "clustered", "--n", "1000000", "--seed", "1", "-o", points], check=True)
        begin = time.monotonic()
        explorer = Explorer(points)
        print(f"a file of 1,000,000 points, {points.stat().st_size / 2**20:.0f} MiB: read after {time.monotonic() - begin:.1f} s")
        try:
            with browser.Browser(390, 844) as page:
                page.open(f"{explorer.address}#{SMALL}")
                wait_until_complete(page)
                print("at 390 pixels:", times_of(page, f"given={points}&{GREEDY}"))
                measure_moving(page, "1,000,000 points")
        finally:
            explorer.stop()


def processor():
    lines = pathlib.Path("/proc/cpuinfo").read_text().splitlines()
    return next(line.split(": ")[1] for line in lines if line.startswith("model name"))


def main():
    if len(sys.argv) < 2:
        sys.exit("usage: measure.py MWT [drag] [large] [million]")
    wanted = sys.argv[2:] or ["drag", "large", "million"]
    print(f"{processor()}, {os.cpu_count()} processors, load {os.getloadavg()[0]:.1f}")
    explorer = Explorer()
    try:
        with browser.Browser(1440, 900) as page:
            for name, measure in (("drag", measure_dragging), ("large", measure_large), ("million", measure_million)):
                if name in wanted:
                    measure(page, explorer)
    finally:
        explorer.stop()
    if "million" in wanted:
        measure_file()


if __name__ == "__main__":
    main()
