"""The examples of the manual run, and the lines of the README with nothing but NumPy."""

import re
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


def test_readme(monkeypatch, tmp_path, capsys):
    project = EXAMPLES.parents[1]
    (tmp_path / "examples").symlink_to(project / "examples")
    monkeypatch.chdir(tmp_path)
    for name in ("trimesh", "networkx", "pyvista", "meshio", "scipy", "tqdm"):
        monkeypatch.setitem(sys.modules, name, None)
    [lines] = re.findall("```python\n(.*?)```", (project / "README.md").read_text(encoding="utf-8"), re.DOTALL)
    exec(compile(lines, "README.md", "exec"), {})
    assert "3 loops" in capsys.readouterr().out and "<svg" in (tmp_path / "graph.svg").read_text(encoding="utf-8")
