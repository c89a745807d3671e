"""Makes the wheel: CMake compiles and installs the package, and this packs it. It asks for no other tool of Python."""
import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

TOP = pathlib.Path(__file__).resolve().parent.parent
OPTIONS = {
    "CMAKE_BUILD_TYPE": "Release",
    "CMAKE_UNITY_BUILD": "ON",
    "CGAL_REEB_GRAPH_BUILD_PYTHON": "ON",
    "CGAL_REEB_GRAPH_PYTHON_DIR": ".",
    "Python_EXECUTABLE": sys.executable,
    **{f"CGAL_REEB_GRAPH_BUILD_{part}": "OFF" for part in ("COMPILED", "TESTS", "EXAMPLES", "BENCHMARK", "DOC")},
}


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    version = re.search(r"VERSION (\d+\.\d+\.\d+)\n", (TOP / "CMakeLists.txt").read_text())[1]
    with tempfile.TemporaryDirectory() as folder:
        installed = pathlib.Path(folder, "installed")
        run_cmake("-S", TOP, "-B", f"{folder}/build", *(f"-D{name}={value}" for name, value in OPTIONS.items()))
        run_cmake("--build", f"{folder}/build", "--target", "reeb_graph_python", "--parallel", str(os.cpu_count()))
        run_cmake("--install", f"{folder}/build", "--component", "Python", "--prefix", installed)
        files = {path.relative_to(installed).as_posix(): path.read_bytes() for path in installed.rglob("*.*")}
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    tag = f"{python}-{python}-{platform}"
    info = f"reeb_graph-{version}.dist-info"
    files[f"{info}/METADATA"] = (
        f"Metadata-Version: 2.1\nName: reeb_graph\nVersion: {version}\nRequires-Python: >=3.10\nRequires-Dist: numpy\n"
        "Summary: Exact augmented Reeb graphs of scalar fields on triangle meshes\n"
        "License: GPL-3.0-or-later OR LicenseRef-Commercial\n"
        f"Description-Content-Type: text/markdown\n\n{(TOP / 'README.md').read_text()}").encode()
    files[f"{info}/WHEEL"] = (
        f"Wheel-Version: 1.0\nGenerator: build_wheel.py\nRoot-Is-Purelib: false\nTag: {tag}\n").encode()
    files[f"{info}/LICENSE"] = (TOP / "LICENSE").read_bytes()
    name = f"reeb_graph-{version}-{tag}.whl"
    with zipfile.ZipFile(pathlib.Path(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:
        record = ""
        for path, content in files.items():
            wheel.writestr(path, content)
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            record += f"{path},sha256={digest},{len(content)}\n"
        wheel.writestr(f"{info}/RECORD", f"{record}{info}/RECORD,,\n")
    return name


def run_cmake(*arguments):
    # pip hides the packages of the system, of which NumPy and pybind11 are needed, by its PYTHONPATH.
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    subprocess.run(["cmake", *map(str, arguments)], check=True, env=environment)
