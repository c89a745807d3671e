"""The program and files of NumPy."""

import subprocess

import meshes
import numpy as np
import pytest

TRIANGLES, POINTS = meshes.grid(7, 6, True, True)


@pytest.fixture
def mesh_file(tmp_path):
    meshes.write_off(tmp_path / "mesh.off", TRIANGLES, POINTS)
    return tmp_path / "mesh.off"


def compute(mesh_file, path, *options, arcs="arcs.txt"):
    arguments = [meshes.PROGRAM, "compute", mesh_file, "--scalars", path, "--vertex-arcs", mesh_file.parent / arcs]
    return subprocess.run([*map(str, arguments), *map(str, options)], capture_output=True, text=True, errors="replace")


def test_dtypes(mesh_file):
    scalars = np.random.default_rng(0).permutation(len(POINTS))
    np.savetxt(mesh_file.parent / "scalars.txt", scalars, "%d")
    assert compute(mesh_file, mesh_file.parent / "scalars.txt").returncode == 0
    expected = (mesh_file.parent / "arcs.txt").read_text()
    for dtype in ("f4", "f8", ">f4", ">f8", "i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8", ">i2", ">u8", ">i8"):
        np.save(mesh_file.parent / "scalars.npy", scalars.astype(dtype))
        assert compute(mesh_file, mesh_file.parent / "scalars.npy").returncode == 0, dtype
        assert (mesh_file.parent / "arcs.txt").read_text() == expected
    with open(mesh_file.parent / "scalars.npy", "wb") as file:
        np.lib.format.write_array(file, scalars.astype(float), version=(2, 0))
    assert compute(mesh_file, mesh_file.parent / "scalars.npy").returncode == 0
    assert compute(mesh_file, mesh_file.parent / "scalars.npy", arcs="arcs.npy").returncode == 0
    places = np.load(mesh_file.parent / "arcs.npy")
    names = expected.split()
    numbers = np.array(names[1::2], dtype=int)
    number_of_nodes = places[np.array(names[::2]) == "arc"].min() - numbers[np.array(names[::2]) == "arc"].min()
    assert np.array_equal(places, np.where(np.array(names[::2]) == "arc", numbers + number_of_nodes, numbers))
    assert places.dtype == np.int64


@pytest.mark.parametrize("array, text", [
    (np.zeros(5), "shape"),
    (np.zeros((len(POINTS), 1)), "shape"),
    (np.zeros(()), "shape"),
    (np.zeros(len(POINTS), dtype=complex), "dtype"),
    (np.zeros(len(POINTS), dtype="U3"), "dtype"),
    (np.zeros(len(POINTS), dtype=[("a", "f8")]), "dtype"),
    (np.zeros(len(POINTS), dtype="f2"), "dtype"),
    (np.full(len(POINTS), 2**63 - 1), "no double"),
    (np.full(len(POINTS), 2**64 - 1, dtype=np.uint64), "no double"),
    (np.full(len(POINTS), np.nan), "NaN"),
])
def test_wrong_arrays(mesh_file, array, text):
    np.save(mesh_file.parent / "scalars.npy", array)
    done = compute(mesh_file, mesh_file.parent / "scalars.npy")
    assert done.returncode == 1 and text in done.stderr


def test_wrong_files(mesh_file):
    path = mesh_file.parent / "scalars.npy"
    np.save(path, POINTS[:, 0])
    good = path.read_bytes()
    random = np.random.default_rng(1)
    for size in (0, 3, 7, 9, 11, 60, len(good) - 1):
        path.write_bytes(good[:size])
        assert compute(mesh_file, path).returncode == 1
    path.write_bytes(good + b"x")
    assert compute(mesh_file, path).returncode == 1
    for _ in range(20):
        bad = bytearray(good)
        for place in random.integers(0, 100, 3):
            bad[place] = random.integers(0, 256)
        path.write_bytes(bad)
        assert compute(mesh_file, path).returncode in (0, 1)
    path.write_bytes(good)
    done = compute(mesh_file, path, "--column", "0")
    assert done.returncode == 1 and "--column" in done.stderr
