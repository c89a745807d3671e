"""Wrong arguments are errors of Python, and nothing ends the interpreter."""

import shutil
import subprocess
import sys
import threading
import time
import types
from pathlib import Path

import meshes
import numpy as np
import pytest
import reeb_graph

TRIANGLES, POINTS = meshes.sphere(1)
SCALARS = POINTS[:, 2] + 0.1 * POINTS[:, 0]


def changed(array, index, value):
    result = np.array(array)
    result[index] = value
    return result


WRONG = [
    ((POINTS, SCALARS), TypeError, "looks like points"),
    (("scan.ply", "z"), FileNotFoundError, "scan.ply"),
    ((TRIANGLES[:, :2], SCALARS), ValueError, "shape"),
    ((TRIANGLES.ravel(), SCALARS), ValueError, "shape"),
    ((TRIANGLES.astype(str), SCALARS), TypeError, "dtype"),
    ((TRIANGLES > 3, SCALARS), TypeError, "dtype"),
    ((None, SCALARS.reshape(-1, 1)), ValueError, "shape"),
    ((TRIANGLES, SCALARS.astype(complex)), TypeError, "dtype"),
    ((TRIANGLES, SCALARS.astype(object)), TypeError, "dtype"),
    ((TRIANGLES, 3.0), ValueError, "shape"),
    ((object(), SCALARS), TypeError, "dtype"),
    ((TRIANGLES, np.broadcast_to(1.0, 2**40)), ValueError, "at most"),
    ((np.broadcast_to(np.arange(3), (2**40, 3)), SCALARS), ValueError, "at most"),
]
WRONG_ITEMS = [
    (changed(TRIANGLES, (3, 1), 99), SCALARS, {"face": 3}),
    (changed(TRIANGLES, (3, 1), -1), SCALARS, {"triangle": 3}),
    (changed(TRIANGLES, (3, 1), 2**63 - 1), SCALARS, {"face": 3}),
    (changed(TRIANGLES, (4, 1), TRIANGLES[4, 0]), SCALARS, {"face": 4}),
    (TRIANGLES, changed(SCALARS, 5, np.nan), {"vertex": 5}),
    (TRIANGLES, np.ma.masked_array(SCALARS, np.arange(len(SCALARS)) == 7), {"vertex": 7}),
    (TRIANGLES, changed(SCALARS.astype("g") + np.longdouble(1) / 3, 6, np.nan), {"vertex": 6}),
    (TRIANGLES, SCALARS[:-1], {"vertex": None}),
]


@pytest.mark.parametrize("arguments, error, text", WRONG)
def test_wrong_arrays(arguments, error, text):
    with pytest.raises(error, match=text):
        reeb_graph.compute(*arguments)


@pytest.mark.parametrize("triangles, scalars, attributes", WRONG_ITEMS)
def test_wrong_items(triangles, scalars, attributes):
    with pytest.raises(reeb_graph.MeshError) as caught:
        reeb_graph.compute(triangles, scalars)
    assert isinstance(caught.value, ValueError)
    for name, number in attributes.items():
        assert number is None or getattr(caught.value, name) == number
        assert number is None or str(number) in str(caught.value)


def test_wrong_options():
    for options in ({"ties": "x"}, {"threads": 0}, {"threads": 10**6}, {"points": POINTS[1:]}, {"points": POINTS[:, :1]},
                    {"points": changed(POINTS, (3, 2), np.inf)}, {"edges": [[0, 0]]}, {"edges": [[0, 99]]},
                    {"tetrahedra": [[0, 1, 2, 99]]}, {"tetrahedra": [[0, 1, 2]]}):
        with pytest.raises(ValueError):
            reeb_graph.compute(TRIANGLES, SCALARS, **options)
    for options in ({"threads": 1.5}, {"threads": True}, {"progress": 3}, {"points": POINTS.astype(complex)}):
        with pytest.raises(TypeError):
            reeb_graph.compute(TRIANGLES, SCALARS, **options)


def test_wrong_questions():
    graph = reeb_graph.compute(TRIANGLES, SCALARS, points=POINTS)
    for arc in (-1, graph.n_arcs, 2**70):
        with pytest.raises(ValueError):
            graph.contour(arc, 0.5)
        with pytest.raises(IndexError):
            graph.critical_set(arc if arc < 0 else arc + graph.n_nodes)
    for t in (0, 1, -1, np.nan, np.inf):
        with pytest.raises(ValueError):
            graph.contour(0, t)
    with pytest.raises(ValueError):
        graph.contours(np.nan)
    for arguments, options in (((), {}), ((-1,), {}), ((np.nan,), {}), (("x",), {}), ((1,), {"percent": 1}),
                               ((), {"leaves": -1}), ((), {"leaves": 2, "cancel_loops": True})):
        with pytest.raises(ValueError):
            graph.simplify(*arguments, **options)
    with pytest.raises(ValueError):
        graph.embed("x")
    without = reeb_graph.compute(TRIANGLES, SCALARS)
    for ask in (lambda: without.contour(0, 0.5), without.lengths, without.embed, lambda: without.write("x.obj")):
        with pytest.raises(ValueError, match="points"):
            ask()
    with pytest.raises(ValueError, match="ends in"):
        graph.write("graph.xyz")
    with pytest.raises(OSError):
        graph.write("/no such folder/graph.svg")


def masked(array, index):
    mask = np.zeros(np.shape(array), bool)
    mask[index] = True
    return np.ma.masked_array(array, mask)


def test_masks():
    """A masked item of any array is an error that names it, as that of a scalar is."""
    ranks = np.arange(len(SCALARS))
    edges, tetrahedra = np.array([[0, 5], [1, 6], [2, 7]]), np.array([[0, 1, 2, 3], [4, 5, 6, 7]])
    for arguments, options, item, number in (
        ((TRIANGLES, masked(SCALARS, 7)), {}, "vertex", 7),
        ((masked(TRIANGLES, (3, 1)), SCALARS), {}, "triangle", 3),
        ((TRIANGLES, SCALARS), {"edges": masked(edges, (2, 0))}, "edge", 2),
        ((TRIANGLES, SCALARS), {"tetrahedra": masked(tetrahedra, (1, 3))}, "tetrahedron", 1),
        ((TRIANGLES, SCALARS), {"points": masked(POINTS, (4, 2))}, "vertex", 4),
        ((TRIANGLES, SCALARS), {"order": masked(ranks, 6)}, "vertex", 6),
    ):
        with pytest.raises(reeb_graph.MeshError, match=f"{item} {number} has no value: it is masked") as caught:
            reeb_graph.compute(*arguments, **options)
        assert getattr(caught.value, item) == number
        unmasked = [getattr(array, "data", array) if isinstance(array, np.ma.MaskedArray) else array for array in arguments]
        reeb_graph.compute(*unmasked)  # no mask is no error, nor is one that masks nothing
        reeb_graph.compute(*(np.ma.masked_array(array) for array in unmasked))
    for ask in (lambda: reeb_graph.geodesic(TRIANGLES, masked(POINTS, (4, 2))),
                lambda: reeb_graph.geodesic(TRIANGLES, POINTS, sources=masked([3, 4], 1)),
                lambda: reeb_graph.height(TRIANGLES, POINTS, masked([0.0, 1.0, 2.0], 1)),
                lambda: reeb_graph.make_borders_level(TRIANGLES, masked(SCALARS, 3)),
                lambda: reeb_graph.branches(TRIANGLES, SCALARS, POINTS, vertex_arrays={"a": masked(SCALARS, 3)})):
        with pytest.raises(reeb_graph.MeshError, match="it is masked"):
            ask()


def test_numbers_of_python():
    """Numbers that no number of C has, and what is no number, give messages of our own."""
    graph = reeb_graph.compute(TRIANGLES, SCALARS, points=POINTS)
    huge = 10**400
    own = "must not be|has to be|too large for a double|there is no arc"
    for ask in (lambda: graph.simplify(huge), lambda: graph.simplify(percent=huge), lambda: graph.simplify(-huge),
                lambda: graph.simplify([1]), lambda: graph.simplify(leaves=1.5), lambda: graph.simplify(leaves="x"),
                lambda: graph.contours(None), lambda: graph.contours(huge), lambda: graph.contours("x"),
                lambda: graph.contours([0.5, 1.5]), lambda: graph.contour(0, None), lambda: graph.contour(None, 0.5),
                lambda: graph.contour(0, huge), lambda: graph.contours_of_arcs(None), lambda: graph.critical_set("x"),
                lambda: reeb_graph.branches(TRIANGLES, SCALARS, POINTS, persistence=huge),
                lambda: reeb_graph.branches(TRIANGLES, SCALARS, POINTS, area="x"),
                lambda: reeb_graph.pants(TRIANGLES, SCALARS, POINTS, max_triangles="x")):
        with pytest.raises((ValueError, TypeError), match=own):
            ask()
    assert graph.simplify(leaves=10**30).n_leaves == graph.n_leaves


@pytest.mark.parametrize("seed", range(300))
def test_random_inputs(seed):
    """Anything gives a graph, or an error that is one of those that are documented."""
    random = np.random.default_rng(seed)
    n, m = random.integers(0, 12, 2)
    low, high = (-1, n + 1) if seed % 3 == 0 else (0, max(n, 1))
    dtype = random.choice(["i4", "i8", "u1", "f8", "u8", ">i4"])
    triangles = random.integers(low, high + (seed % 3 == 0), size=(m, random.choice([3, 3, 3, 3, 2, 4]))).astype(dtype)
    scalars = random.choice([0, 1, np.nan, np.inf, 2.5], n, p=[0.3, 0.3, 0.02, 0.08, 0.3])
    options = {
        "points": random.normal(size=(n + (seed % 11 == 0), 3)),
        "edges": random.integers(0, max(n, 1), size=(random.integers(0, 4), 2)) if seed % 2 else None,
        "tetrahedra": random.integers(0, max(n, 1), size=(random.integers(0, 4), 4)) if seed % 5 == 0 else None,
        "order": random.integers(0, 9, n) if seed % 7 == 0 else None,
        "ties": random.choice(["perturb", "contract"]),
        "keep_degree_2": bool(seed % 2),
    }
    try:
        graph = reeb_graph.compute(triangles, scalars, **options)
    except (ValueError, TypeError):
        return
    assert len(graph.vertex_places) == n and graph.n_loops >= 0
    assert len(graph.chains) == graph.n_arcs and len(graph.pairs()) >= graph.n_components
    try:
        graph.contours_of_arcs(0.3)
        graph.simplify(0.7).vertex_places
        graph._repr_svg_()
        graph.embed()
    except (ValueError, TypeError):
        pass


def test_progress():
    triangles, points = meshes.grid(300, 300, True, True)
    scalars = np.random.default_rng(0).normal(size=len(points))
    told = []
    reeb_graph.compute(triangles, scalars, progress=told.append)
    assert told == sorted(told) and told[-1] == 1
    with pytest.raises(reeb_graph.StoppedError):
        reeb_graph.compute(triangles, scalars, progress=lambda fraction: False)
    with pytest.raises(ZeroDivisionError):
        reeb_graph.compute(triangles, scalars, progress=lambda fraction: 1 / 0)


@pytest.mark.parametrize("has_tqdm", [False, True])
def test_progress_shown(monkeypatch, capsys, has_tqdm):
    class Bar:
        def __init__(self, total, desc, bar_format):
            self.n, self.total, self.is_closed = 0, total, False
            bars.append(self)

        def update(self, number):
            self.n += number

        def close(self):
            self.is_closed = True

    bars = []
    monkeypatch.setitem(sys.modules, "tqdm", types.ModuleType("tqdm") if has_tqdm else None)
    monkeypatch.setitem(sys.modules, "tqdm.auto", types.SimpleNamespace(tqdm=Bar) if has_tqdm else None)
    reeb_graph.compute(TRIANGLES, SCALARS, progress=True)
    if has_tqdm:
        assert [(bar.n, bar.is_closed) for bar in bars] == [(100, True)] and capsys.readouterr().err == ""
    else:
        assert capsys.readouterr().err.endswith("100 %\n")


def test_arrays_that_change_meanwhile():
    triangles, points = meshes.grid(250, 250, True, True)
    scalars = points[:, 0].copy()
    expected = reeb_graph.compute(triangles, scalars)
    done = threading.Event()

    def change():
        while not done.is_set():
            triangles[:] = 2**40
            scalars[:] = np.nan
            time.sleep(0)

    given = [triangles.copy(), scalars.copy()]
    results = []
    compute = threading.Thread(target=lambda: results.append(reeb_graph.compute(triangles, scalars)))
    worker = threading.Thread(target=change)
    compute.start()
    time.sleep(0.005)
    worker.start()
    compute.join()
    done.set()
    worker.join()
    if results:  # else it began to change too early, which is an error of the thread
        assert np.array_equal(results[0].arcs, expected.arcs)
    assert np.array_equal(reeb_graph.compute(*given).arcs, expected.arcs)


def test_lock_is_released():
    triangles, points = meshes.grid(400, 400, True, True)
    scalars = np.random.default_rng(0).normal(size=len(points))
    ticks = []
    worker = threading.Thread(target=lambda: ticks.append(reeb_graph.compute(triangles, scalars).n_nodes))
    worker.start()
    counted = 0
    while worker.is_alive():
        counted += 1
    assert ticks and counted > 1000


def test_control_c_ends_a_run():
    code = """
import os, signal, threading, time, numpy as np, meshes, reeb_graph
triangles, points = meshes.grid(2000, 1000, True, True)
scalars = np.random.default_rng(0).normal(size=len(points))
signal.signal(signal.SIGINT, signal.default_int_handler)
pressed = []
def press():
    pressed.append(time.monotonic())
    os.kill(os.getpid(), signal.SIGINT)
begin = time.monotonic()
reeb_graph.compute(triangles, scalars, threads=1)
whole = time.monotonic() - begin
threading.Timer(whole / 3, press).start()
try:
    while True:
        reeb_graph.compute(triangles, scalars, threads=1)
except KeyboardInterrupt:
    print((time.monotonic() - pressed[0]) / whole)
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=Path(__file__).parent)
    assert done.returncode == 0, done.stderr
    assert float(done.stdout) < 0.6  # of the time of a run, of which two thirds were left


def test_import_without_the_extension(tmp_path):
    shutil.copytree(Path(reeb_graph.__file__).parent, tmp_path / "reeb_graph", ignore=shutil.ignore_patterns("_core*"))
    code = f"import sys; sys.path.insert(0, {str(tmp_path)!r}); import reeb_graph"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.returncode != 0 and "--target reeb_graph_python" in done.stderr and "pip install ." in done.stderr


def test_import_is_quick():
    code = "import numpy, time; t = time.process_time(); import reeb_graph; print(time.process_time() - t)"
    times = [float(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout)
             for _ in range(3)]
    assert min(times) < 0.15
