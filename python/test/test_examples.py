"""The examples of the manual run."""

import runpy
import sys
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[1] / "examples"


@pytest.mark.parametrize("name", sorted(path.name for path in EXAMPLES.glob("*.py")))
def test_example(monkeypatch, tmp_path, capsys, name):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", [str(EXAMPLES), *sys.path])
    runpy.run_path(str(EXAMPLES / name))
    drawn = list(tmp_path.glob("*.svg"))
    assert name == "shapes.py" or (capsys.readouterr().out and drawn and all(path.stat().st_size > 500 for path in drawn))
