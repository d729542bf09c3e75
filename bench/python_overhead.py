"""What Python costs: calls against the C++ run inside them, a sweep of 1e5 balloons against the program's, paired and
alternating. PYTHONPATH=build/release/python python3 bench/python_overhead.py build/release/bin/turgor cases [MEMBERS]"""

import json
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import turgor


def call_overhead(case, count):
    """Time of case.run() beyond run_case() [us], median of `count`."""
    beyond = []
    for _ in range(count):
        start = time.perf_counter()
        run = case.run()
        beyond.append(1e6 * (time.perf_counter() - start - run._native.seconds))
    return statistics.median(beyond)


def sweeps(program, cases, members, pairs):
    """Computing and whole time of sweeps of as many balloons [s]: Python's, the program's, medians."""
    times = {"python": [], "program": []}
    whole = {"python": [], "program": []}
    table = {"sampler": "latin-hypercube", "members": members, "quantities": ["peak_stretch", "final_stretch"],
             "axes": {"inlet.orifice_radius": {"from": "1 cm", "to": "3 cm"}}}
    case = turgor.Case.read(cases / "sweep-orifice-pressure.toml", sweep=table)
    with tempfile.TemporaryDirectory() as folder:
        text = Path(folder, "case.toml")
        text.write_text(case.resolved)
        case = turgor.Case.read(text)
        for _ in range(pairs):
            start = time.perf_counter()
            times["python"].append(case.sweep(Path(folder, "python.nc"), force=True).seconds)
            whole["python"].append(time.perf_counter() - start)
            command = [program, "sweep", str(text), "-o", f"{folder}/program.nc", "--force", "--no-pictures", "--json"]
            start = time.perf_counter()
            answer = subprocess.run(command, check=True, capture_output=True, text=True).stdout
            whole["program"].append(time.perf_counter() - start)
            times["program"].append(json.loads(answer)["seconds"])
    ratio = statistics.median(a / b for a, b in zip(times["python"], times["program"]))
    return times, whole, ratio


def main():
    program, cases = sys.argv[1], Path(sys.argv[2])
    members = int(sys.argv[3]) if len(sys.argv) > 3 else 100_000
    case = turgor.Case.read(cases / "orifice-30mm.toml")
    short = case.replace({"solve.t_end": "1 s", "solve.samples": 10})
    for name, each in (("orifice-30mm", case), ("its first second", short)):
        run = each.run()
        print(f"{name}: run_case {1e6 * run._native.seconds:.0f} us, a call {call_overhead(each, 500):.1f} us more")
    times, whole, ratio = sweeps(program, cases, members, 15)
    for who in times:
        print(f"sweep of {members} by the {who}: computing {statistics.median(times[who]):.2f} s, "
              f"all {statistics.median(whole[who]):.2f} s")
    print(f"Python over program, computing, median of 15 pairs: {ratio:.3f}")


main()
