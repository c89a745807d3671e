"""Prints what the Reeb graph takes on ranks of MPI, beside the program of one process with one thread on the same file.

Usage: benchmark_ranks.py FOLDER_OF_PROGRAMS TRIANGLES RANKS... ; scripts/benchmark --mpi calls it.
Seconds are those of CPU, summed over all ranks: in all, and reading apart. The one process links the triangles while it
reads, ranks do not before they have exchanged them. With more ranks than cores, ranks that wait for a message spend CPU
as well. Memory is that of the rank that has most.
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

programs, triangles, *numbers_of_ranks = sys.argv[1:]
project = pathlib.Path(__file__).resolve().parents[2]


def run_on_ranks(ranks, *arguments):
    command = [project / "scripts" / "run_on_ranks", str(ranks), programs + "/reeb_graph_mpi", *arguments]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def run_sequentially(*arguments):
    """The report, the seconds of CPU, and those without reading, by the parts of the time on the clock."""
    with tempfile.TemporaryFile("w+") as output:
        process = subprocess.Popen([programs + "/reeb_graph", *arguments], stdout=output)
        _, status, usage = os.wait4(process.pid, 0)
        if status != 0:
            sys.exit("reeb_graph has failed")
        output.seek(0)
        report = json.load(output)
    spent = report["seconds"]
    steps = [step for step in spent if step not in ("flatten", "classify", "arcs", "write")]
    share = 1 - spent["read"] / sum(spent[step] for step in steps)
    seconds = usage.ru_utime + usage.ru_stime
    return report, seconds, share * seconds


def content(path):
    with open(path, "rb") as file:
        return file.read()


columns = "{:<8} {:>10} {:>5} {:>5} {:>8} {:>6} {:>10} {:>6} {:>6} {:>6} {:>8} {:>12}"
print(columns.format("field", "triangles", "ranks", "slabs", "all [s]", "ratio", "graph [s]", "ratio", "MB", "ratio", "copies",
                     "sent [B/tri]"))
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    for field in ("smooth", "y", "noise"):
        subprocess.run([programs + "/write_plate", "mesh.ply", triangles, "noise" if field == "noise" else "smooth"], check=True)
        arguments = ["compute", "mesh.ply", "--field", field, "--no-table", "--json", "--graph"]
        one, all_seconds, one_seconds = run_sequentially(*arguments, "one.dot", "--threads", "1")
        print(columns.format("height" if field == "y" else field, one["faces"], "-", "-", f"{all_seconds:.2f}",
                             "1.00", f"{one_seconds:.2f}", "1.00", f"{one['peak_memory_bytes'] / 1e6:.0f}", "1.00", "-", "-"))
        for ranks in numbers_of_ranks:
            report = json.loads(run_on_ranks(ranks, *arguments, "ranks.dot"))
            if content("one.dot") != content("ranks.dot"):
                sys.exit(f"the graph on {ranks} ranks is another one")
            cpu = report["cpu_seconds"]
            seconds = cpu["compute"] + cpu["output"]
            copies = sum(rank["copies"] for rank in report["per_rank"]) / report["faces"]
            sent = sum(rank["bytes_sent"] for rank in report["per_rank"]) / report["faces"]
            print(columns.format("", "", ranks, report["slabs"], f"{cpu['total']:.2f}",
                                 f"{cpu['total'] / all_seconds:.2f}", f"{seconds:.2f}",
                                 f"{seconds / one_seconds:.2f}", f"{report['peak_memory_bytes'] / 1e6:.0f}",
                                 f"{report['peak_memory_bytes'] / one['peak_memory_bytes']:.2f}", f"{copies:.1%}",
                                 f"{sent:.1f}"))
