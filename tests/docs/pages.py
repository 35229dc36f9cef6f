# SPDX-License-Identifier: BSD-3-Clause
"""Builds the pages with every warning an error; follows each link inside them; looks for what a page would load from
elsewhere. Usage: pages.py ENVIRONMENT SPHK WORK"""

import os
import shutil
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

import docs_environment

docs_environment.enter(sys.argv[1])

LOADED = dict.fromkeys(["script", "img", "iframe", "source", "video"], "src") | {"object": "data", "link": "href"}


class Page(HTMLParser):
    """What a page links to, loads, and offers to be linked to."""

    def __init__(self, path):
        super().__init__()
        self.links, self.loads, self.anchors = [], [], set()
        self.feed(path.read_text())

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.anchors.add(values.get("id"))
        if tag == "a" and values.get("href"):
            self.links.append(values["href"])
        if values.get(LOADED.get(tag)) and values.get("rel") not in ("prev", "next", "search", "index", "canonical"):
            self.loads.append(values[LOADED[tag]])


def faults(folder):
    """Sentences on links that lead nowhere and on files that come from elsewhere."""
    pages = {path: Page(path) for path in sorted(folder.rglob("*.html"))}
    assert len(pages) > 40, f"only {len(pages)} pages were built"
    for path, page in pages.items():
        name = path.relative_to(folder)
        for link in page.links + page.loads:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                if link in page.loads and parts.scheme != "data":
                    yield f"{name} loads {link} from the network"
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            if not target.exists():
                yield f"{name} links to {link}, which is not there"
            elif parts.fragment and target in pages and unquote(parts.fragment) not in pages[target].anchors:
                yield f"{name} links to {link}, a place that its page does not have"
    for sheet in folder.rglob("*.css"):
        for word in ("url(http", "url(//", 'url("http', "@import"):
            if word in sheet.read_text():
                yield f"{sheet.relative_to(folder)} has {word}"


def main():
    if not shutil.which("doxygen"):
        print("skipped: there is no doxygen, which reads the headers")
        sys.exit(docs_environment.SKIPPED)
    html = Path(sys.argv[3]) / "html"
    shutil.rmtree(html, ignore_errors=True)
    build = ["sphinx", "-q", "-W", "-n", "--keep-going", "-d", html.parent / "doctrees"]
    built = subprocess.run([sys.executable, "-B", "-m", *build, docs_environment.ROOT / "docs", html],
                           env={**os.environ, "SPHK_PROGRAM": sys.argv[2]})
    if built.returncode:
        sys.exit("the pages do not build without a warning; what Sphinx says is above")
    found = list(faults(html))
    print("\n".join(found) or f"every link of {html} leads somewhere, and nothing comes from the network")
    sys.exit(len(found) > 0)


main()
