#!/usr/bin/env python3
"""Reads the built book in headless Chromium, from file:// and served, and says what is wrong with it.

    .ci/browser/check.py [target/book] [--pictures FOLDER]

Ends with a line `N passed, N failed`, and with success only where nothing failed.
"""

import argparse
import functools
import http.server
import pathlib
import sys
import threading

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from chromium import Browser, Tab  # noqa: E402

SCRIPT = (pathlib.Path(__file__).parent / "page.js").read_text()
LIGHT, DARK = "light", "navy"
WIDE, NARROW = (1280, 900), (390, 844)
SEARCH = "Coons"


class Tally:
    """Counts checks; failures are printed as they come."""

    def __init__(self):
        self.passed, self.failed = 0, 0

    def check(self, what, problems):
        if problems:
            self.failed += 1
            print(f"FAILED  {what}")
            for problem in problems:
                print(f"        {problem}")
        else:
            self.passed += 1
            print(f"ok      {what}")


class Quiet(http.server.SimpleHTTPRequestHandler):
    """Serves a folder without talking."""

    def log_message(self, *_):
        pass


def serve(folder):
    handler = functools.partial(Quiet, directory=str(folder))
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return server, f"http://127.0.0.1:{server.server_address[1]}/"


def book_pages(folder):
    """The pages of the book itself; the rustdoc pages are another program's."""
    pages = sorted(p.relative_to(folder).as_posix() for p in folder.rglob("*.html"))
    return [p for p in pages if not p.startswith("api/") and p != "toc.html"]


def outside(requests, base):
    """Requests that leave the folder."""
    local = (base, "data:", "blob:", "about:")
    return [f"a request leaves the folder: {url}" for url in requests if not url.startswith(local)]


def check_page(tally, tab, base, page, what):
    requests, complaints = tab.open(base + page)
    problems = outside(requests, base) + complaints
    result = tab.evaluate(SCRIPT)
    late_requests, late_complaints = tab.noted()
    problems += outside(late_requests[len(requests):], base) + late_complaints[len(complaints):]
    tally.check(f"{page}, {what}", problems + result["wrong"])
    return result


def check_search(tally, tab, base, what):
    """Types a word into the search as a reader does and looks for results."""
    requests, complaints = tab.open(f"{base}index.html")
    tab.evaluate("document.getElementById('mdbook-search-toggle').click()")
    tab.evaluate(
        "new Promise((done, fail) => { let n = 0; const t = setInterval(() => {"
        " if (window.search && window.search.hasFocus || n++ > 40) { clearInterval(t); done(); } }, 50); })"
    )
    tab.evaluate(
        "{ const bar = document.getElementById('mdbook-searchbar'); bar.focus();"
        f" bar.value = '{SEARCH}'; bar.dispatchEvent(new KeyboardEvent('keyup', {{ key: 's', bubbles: true }}));"
        " bar.dispatchEvent(new Event('input', { bubbles: true })); }"
    )
    count = tab.evaluate(
        "new Promise((done) => { let n = 0; const t = setInterval(() => {"
        " const found = document.querySelectorAll('#mdbook-searchresults li').length;"
        " if (found > 0 || n++ > 60) { clearInterval(t); done(found); } }, 50); })"
    )
    requests, complaints = tab.noted()
    problems = outside(requests, base) + complaints
    if not count:
        problems.append(f"the search finds no `{SEARCH}`")
    tally.check(f"the search for `{SEARCH}`, {what}", problems)


def check_base(tally, browser, folder, base, source, pictures):
    formulas = 0
    for size in (WIDE, NARROW):
        for theme in (LIGHT, DARK):
            tab = Tab(browser, *size, theme)
            for page in book_pages(folder):
                result = check_page(tally, tab, base, page, f"{source}, {theme}, {size[0]} pixels")
                formulas += result["formulas"]
                if theme not in result["theme"].split():
                    tally.check(f"{page} follows the theme {theme}", [f"it is `{result['theme']}`"])
                if pictures:
                    name = page.replace("/", "-").removesuffix(".html")
                    tab.picture(pictures / f"{source}-{theme}-{size[0]}-{name}.png")
            tab.close()
    tally.check(f"the pages have formulas, {source}", [] if formulas else ["not a single one"])
    tab = Tab(browser, *WIDE)
    check_search(tally, tab, base, source)
    tab.close()


def main():
    root = pathlib.Path(__file__).resolve().parents[2]
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("book", nargs="?", type=pathlib.Path, default=root / "target/book")
    parser.add_argument("--pictures", type=pathlib.Path, help="writes a picture of each page there")
    options = parser.parse_args()
    folder = options.book.resolve()
    if not (folder / "index.html").is_file():
        raise SystemExit(f"error: no book in {folder}; `cargo book` builds it")
    if options.pictures:
        options.pictures.mkdir(parents=True, exist_ok=True)
    tally = Tally()
    server, address = serve(folder)
    with Browser() as browser:
        check_base(tally, browser, folder, folder.as_uri() + "/", "file", options.pictures)
        check_base(tally, browser, folder, address, "served", None)
    server.shutdown()
    print(f"{tally.passed} passed, {tally.failed} failed")
    return 1 if tally.failed else 0


if __name__ == "__main__":
    sys.exit(main())
