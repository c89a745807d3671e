"""Makes a manual whole that doxygen has written: each picture gets its caption as its text, and formulas are drawn by the
copy of MathJax that is given. Usage: finish_manual.py HTML_FOLDER [FOLDER_OF_MATHJAX]"""

import html
import pathlib
import re
import shutil
import sys

PICTURE = re.compile(r'(<img src="[^"]*" alt=)""(?=[^<]*/>\s*</div>\s*<center><b>Figure [^<]*</b>(.*?)</center>)', re.DOTALL)
DRAWING = re.compile(r'(<object type="image/svg\+xml" data="[^"]*")(?=.*?</object>\s*</div>\s*<center><b>Figure [^<]*</b>(.*?)</center>)')


def with_text(attribute):
    def replace(match):
        text = " ".join(html.unescape(re.sub("<[^>]*>", "", match[2])).split())
        return f'{match[1]}{attribute}"{html.escape(text)}"'

    return replace


folder = pathlib.Path(sys.argv[1])
for path in folder.glob("*.html"):
    page = path.read_text(encoding="utf-8")
    finished = DRAWING.sub(with_text(' role="img" aria-label='), PICTURE.sub(with_text(""), page))
    if len(sys.argv) > 2:
        finished = re.sub(r'src="[^"]*/MathJax.js"', 'src="mathjax/MathJax.js"', finished)
    if finished != page:
        path.write_text(finished, encoding="utf-8")
if len(sys.argv) > 2:
    needless = ("unpacked", "config", "localization", "test", "SVG", "CommonHTML", "PreviewHTML", "MathML", "AsciiMath")
    shutil.copytree(sys.argv[2], folder / "mathjax", dirs_exist_ok=True,  # links become files
                    ignore=shutil.ignore_patterns(*needless))
