"""Handles and their removal against the program."""

import json

import meshes
import numpy as np
import pytest
import reeb_graph

TRIANGLES, POINTS = meshes.grid(60, 24, True, True)


def spiked(number):
    """Return the points of the torus, where so many vertices at its top are moved through its bottom."""
    points = POINTS.copy()
    points[np.arange(number) * 24 * 7 + 6, 2] = -1.6
    return points


def two_tori():
    triangles = np.concatenate([TRIANGLES, TRIANGLES + len(POINTS)])
    return triangles, np.concatenate([POINTS, 0.1 * POINTS + 9])


def loops_of_program(tmp_path, triangles, points, *options):
    meshes.write_off(tmp_path / "mesh.off", triangles, points)
    return json.loads(meshes.run("handles", tmp_path / "mesh.off", "--json", *options))


@pytest.mark.parametrize("triangles, points, options, of_program", [
    (TRIANGLES, POINTS, {}, []),
    (*two_tori(), {"shorten": False}, ["--no-shortening"]),
    (TRIANGLES[1:], POINTS, {}, []),
    (TRIANGLES, spiked(1), {}, []),
    (TRIANGLES, spiked(3), {"ignore_self_intersections": True}, ["--ignore-self-intersections"]),
])
def test_loops_as_the_program(tmp_path, triangles, points, options, of_program):
    found = reeb_graph.handles(triangles, points, **options)
    expected = loops_of_program(tmp_path, triangles, points, *of_program)
    assert found.intersecting_pairs == expected["intersecting_pairs"]
    assert len(found.loops) == len(expected["loops"]) >= 2
    for loop, row in zip(found.loops, expected["loops"]):
        for key in ("kind", "length", "component", "partner", "persistence", "simple", "certain"):
            assert getattr(loop, key) == row[key]
        assert loop.area == pytest.approx(row["area"], rel=1e-12)  # among discs that are as good, addresses decide
        for key in ("center", "box", "vertices"):
            assert np.array_equal(getattr(loop, key), row[key])


def test_places():
    handle, tunnel = reeb_graph.handles(TRIANGLES, POINTS).loops
    assert (handle.kind, tunnel.kind, handle.partner, tunnel.partner) == ("handle", "tunnel", 1, 0)
    for loop in (handle, tunnel):
        along = POINTS[loop.vertices]
        lengths = np.linalg.norm(np.roll(along, -1, axis=0) - along, axis=1)
        assert np.isclose(lengths.sum(), loop.length)
        middles = (along + np.roll(along, -1, axis=0)) / 2
        assert np.allclose(loop.center, lengths @ middles / loop.length)
        assert np.array_equal(loop.box, [along.min(axis=0), along.max(axis=0)])
    assert "handle of length 6.2" in repr(handle)


@pytest.mark.parametrize("number_of_spikes", [1, 2, 5])
def test_spikes_change_no_kind(number_of_spikes):
    points = spiked(number_of_spikes)
    whole = reeb_graph.handles(TRIANGLES, POINTS).loops
    refused = reeb_graph.handles(TRIANGLES, points)
    assert refused.intersecting_pairs > 0 and all(loop.certain for loop in refused.loops)
    assert [loop.kind for loop in refused.loops] == ["loop", "loop"]
    told = reeb_graph.handles(TRIANGLES, points, ignore_self_intersections=True)
    assert told.intersecting_pairs == refused.intersecting_pairs and not any(loop.certain for loop in told.loops)
    assert repr(told) == "<Handles: 1 handle, 1 tunnel, 0 holes, 0 loops>"
    for loop, short, expected in zip(told.loops, refused.loops, whole):
        assert loop.kind == expected.kind
        assert abs(loop.length / expected.length - 1) < 0.05 and abs(short.length / expected.length - 1) < 0.05


def test_removal(tmp_path):
    triangles, points = two_tori()
    arrays = {"height": points[:, 2], "number": np.arange(len(points))}
    cut = reeb_graph.remove_handles(triangles, points, below=2, vertex_arrays=arrays)
    expected = loops_of_program(tmp_path, triangles, points, "--remove-below", 2, "--output", tmp_path / "clean.off")
    words = (tmp_path / "clean.off").read_text().split()
    end = 4 + cut.points.size
    assert words[1:3] == [str(len(cut.points)), str(len(cut.triangles))]
    assert np.array_equal(cut.points, np.reshape(words[4:end], (-1, 3)).astype(float))
    assert np.array_equal(cut.triangles, np.reshape(words[end:], (-1, 4))[:, 1:].astype(int))
    assert np.array_equal(cut.vertex_arrays["number"][: len(points)], np.arange(len(points)))
    assert len(cut.vertex_arrays["height"]) == len(cut.points)
    [removal], [row] = cut.removals, expected["removals"]
    assert removal.reason == ""
    for key in ("kind", "length", "component"):
        assert getattr(removal, key) == row[key]
    assert np.array_equal(removal.vertices, row["vertices"]) and np.array_equal(removal.box, row["box"])
    assert [loop.component for loop in reeb_graph.handles(cut.triangles, cut.points).loops] == [0, 0]
    percents = float(200 / np.linalg.norm(np.ptp(points, axis=0)))
    for below in (f"{percents!r}%", f"{percents!r} %"):
        assert len(reeb_graph.remove_handles(triangles, points, below=below).removals) == 1
    assert not reeb_graph.remove_handles(triangles, points, below="0 %").removals
    assert len(reeb_graph.remove_handles(triangles, points, number=0).removals) == 0
    assert len(reeb_graph.remove_handles(triangles, points, number=2).removals) == 2
    spike = reeb_graph.remove_handles(TRIANGLES, spiked(1), below=7)  # which is not told apart by sides
    assert [removal.kind for removal in spike.removals] == ["loop"]


def test_errors():
    with pytest.raises(ValueError, match="need points"):
        reeb_graph.handles(TRIANGLES)
    with pytest.raises(ValueError, match="below or number"):
        reeb_graph.remove_handles(TRIANGLES, POINTS)
    with pytest.raises(ValueError, match="negative"):
        reeb_graph.remove_handles(TRIANGLES, POINTS, below=-1)
    with pytest.raises(ValueError, match="neither a number nor a percentage"):
        reeb_graph.remove_handles(TRIANGLES, POINTS, below="5x")
    with pytest.raises(TypeError):
        reeb_graph.remove_handles(TRIANGLES, POINTS, number=1.5)
    with pytest.raises(ValueError, match="oriented manifold surface"):
        reeb_graph.handles([[0, 1, 2], [0, 1, 3], [0, 1, 4]], POINTS[:5])
