"""Prints what threads gain: each wish of the README on a surface, with 1, 2, 4, ... threads, as many as there are cores.

Usage: benchmark_threads.py FOLDER_OF_THE_BUILD [VERTICES | MESH]; scripts/benchmark --tables threads calls it.
Beside the seconds on the clock are those of the processor, and the share of the thread that has most to do. What that
one does alone has to wait for it, even while other programs run: Amdahl's law tells from it what 6 threads would gain.
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import time

from benchmark_wishes import WISHES, build, sizes, write_torus


def run(command, options):
    """Seconds on the clock, and those of the processor by thread, from the most to the least."""
    begin, spent = time.monotonic(), {}
    process = subprocess.Popen([build + "/reeb_graph", *command.split(), *options], stdout=subprocess.DEVNULL)
    while process.poll() is None:
        for task in pathlib.Path(f"/proc/{process.pid}/task").glob("*/schedstat"):
            try:
                spent[task.parent.name] = int(task.read_text().split()[0]) / 1e9
            except OSError:
                pass  # It has ended.
        time.sleep(0.005)
    if process.returncode != 0:
        sys.exit(f"reeb_graph {command} has failed")
    return time.monotonic() - begin, sorted(spent.values(), reverse=True)


def main():
    mesh = holes = sizes[0] if sizes else "205000"
    columns = "{:<10} {:>7} {:>9} {:>8} {:>9} {:>9} {:>7} {:>5}"
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        if mesh.isdigit():
            write_torus("torus.off", int(mesh))
            write_torus("holes.off", int(mesh), has_holes=True)
            mesh, holes = "torus.off", "holes.off"
        run(f"field {mesh} --type height --output field.txt", [])
        print(columns.format("wish", "threads", "clock [s]", "CPU [s]", "most [%]", "alone [%]", "gain", "of 6"))
        for name, wish in WISHES.items():
            number, first = 1, None
            while number <= (1 if name == "skeleton" else os.cpu_count() or 1):  # Skeletons have one thread.
                options = ["--threads", str(number)] if name != "skeleton" else []
                clock, spent = run(wish.format(mesh=mesh, holes=holes), options)
                first = first or clock
                total = sum(spent)
                alone = (spent[0] - sum(spent[1:]) / (number - 1)) / total if number > 1 else 1
                print(columns.format(name, number, f"{clock:.2f}", f"{total:.2f}", f"{100 * spent[0] / total:.0f}",
                                     f"{100 * alone:.0f}", f"{first / clock:.2f}",
                                     f"{1 / (alone + (1 - alone) / 6):.1f}" if number > 1 else "-"), flush=True)
                number *= 2
        print("The paper gains 3.8 and 3.5 with 6 threads.")


main()
