"""One line about a run: unknowns, seconds per step at constant rate, share of the linear solver, memory."""

import json
import pathlib
import re
import statistics
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent))
import tables

folder, log, memory = sys.argv[1:]
steady = [row for row in tables.rows(folder + "/solver.csv") if row["t"] > 0.1]
work = json.load(open(folder + "/run.json"))
solve = re.search(r"^KSPSolve\s+\d+\s+[\d.]+\s+([\d.e+-]+)", open(log).read(), re.M)
print(
    f"turgor: {work['discretisation']['unknowns']} unknowns, {statistics.median(r['wall'] for r in steady):.4f} s per step "
    f"(median of {len(steady)}), {sum(r['nonlinear_iterations'] for r in steady) / len(steady):.1f} Newton and "
    f"{sum(r['linear_iterations'] for r in steady) / len(steady):.1f} GMRES iterations per step, linear solver "
    f"{100 * float(solve.group(1)) / work['timings']['integration_s']:.0f} % of the run, {int(open(memory).read().split()[-1]) / 1e6:.2f} GB"
)
