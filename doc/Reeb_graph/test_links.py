"""Fails if a link or a picture of a page of the manual leads nowhere, or a picture has no text. Usage: test_links.py HTML_FOLDER"""

import html.parser
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    """The anchors of a page, and where it refers to."""

    def __init__(self, path):
        super().__init__()
        self.anchors, self.links, self.silent_pictures = set(), [], []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        if tag in ("img", "object") and not dict(attrs).get("alt" if tag == "img" else "aria-label"):
            self.silent_pictures.append(dict(attrs).get("src" if tag == "img" else "data"))
        for name, value in attrs:
            if name == "id" or name == "name" and tag == "a":
                self.anchors.add(value)
            elif value and (name == "href" and tag == "a" or name in ("src", "data") and tag in ("img", "object")):
                self.links.append(value)


folder = pathlib.Path(sys.argv[1])
pages = {path.name: Page(path) for path in sorted(folder.glob("*.html"))}
broken = []
for name, page in pages.items():
    broken += [f"{name}: {picture} has no text" for picture in page.silent_pictures]
    for link in page.links:
        target = urllib.parse.urlparse(link)
        if target.scheme or target.netloc or link == "#":
            continue
        file = urllib.parse.unquote(target.path) or name
        anchor = urllib.parse.unquote(target.fragment)
        if not (folder / file).exists() or anchor and file in pages and anchor not in pages[file].anchors:
            broken.append(f"{name}: {link}")
if not pages:
    broken.append(f"There is no manual in {folder}")
print("\n".join(broken) or f"{len(pages)} pages, {sum(len(page.links) for page in pages.values())} links")
sys.exit(1 if broken else 0)
