#!/usr/bin/env python3
"""Puts the page with the program together: HTML whose markers name the files that stand in their places.

Usage: put_together.py OUTPUT HTML FILE...
Text stays as it is, and what is no script or style is compressed, and coded in base64.
"""

import base64
import gzip
import json
import pathlib
import sys

output, html, *files = map(pathlib.Path, sys.argv[1:])
text, packed = {}, {}
for file in files:
    if file.suffix in (".js", ".css"):
        text[file.name] = file.read_text()
        assert "</script" not in text[file.name].lower() and "</style" not in text[file.name].lower(), file
    else:
        packed[file.name] = base64.b64encode(gzip.compress(file.read_bytes(), 9, mtime=0)).decode()
page = html.read_text()
for name, content in text.items():
    assert f"<!-- {name} -->" in page, name
    page = page.replace(f"<!-- {name} -->", content)
output.write_text(page.replace("<!-- packed -->", json.dumps(packed)))
