# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""run.py PROGRAM MESH RESULT TIMEOUT COMMAND ARGUMENT...: runs the program on a mesh and writes a JSON
file with how that ended, whatever it was, and the statistics if there are any. OUT in an argument
stands for an output that is thrown away. TIMEOUT is in seconds of the processor, so that other work on
the machine does not count; a program that waits may do so ten times as long."""

import json
import math
import resource
import signal
import subprocess
import sys
import tempfile
from pathlib import Path


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(program, mesh, timeout, command, arguments):
    """Returns how the program ended on a mesh, in a dictionary."""
    row = {"mesh": Path(mesh).name, "bytes": Path(mesh).stat().st_size}
    seconds = math.ceil(timeout)
    before = processor_seconds()
    with tempfile.TemporaryDirectory() as scratch:
        arguments = [a.replace("OUT", scratch + "/out") for a in arguments]
        statistics = Path(scratch) / "statistics.json"
        call = [program, command, mesh, *arguments, "--stats", statistics, "--quiet", "--threads", "1"]
        try:
            ended = subprocess.run(call, capture_output=True, text=True, errors="replace", timeout=10 * timeout,
                                   preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5)))
            outcomes = {0: "success", 1: "failure", 2: "refused", -signal.SIGXCPU: "timeout"}
            row["outcome"] = outcomes.get(ended.returncode, "crash")
            row["message"] = ended.stderr.strip().split("\n")[-1]
        except subprocess.TimeoutExpired:
            row["outcome"] = "timeout"
        except OSError as error:
            sys.exit(f"{program}: {error}")
        if row["outcome"] == "timeout":
            row["message"] = f"no result after {timeout:g} seconds"
        row["seconds"] = processor_seconds() - before  # of the processor, whatever else it does
        if statistics.exists():
            row["statistics"] = json.loads(statistics.read_text())
    return row


if __name__ == "__main__":
    program, mesh, result, timeout, command, *arguments = sys.argv[1:]
    row = run(program, mesh, float(timeout), command, arguments)
    row["command"] = Path(result).parent.name
    Path(result).write_text(json.dumps(row))
