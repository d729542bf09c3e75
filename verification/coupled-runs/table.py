"""What finite elements of elastic balloons found and what the model was off by, beside what was recorded:
table.py FOLDER REFERENCE.json [--record]."""

import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent))
import tables


def course_error(parts, course):
    """Greatest error of (2.22) with (2.15) over the parts of a course, in % of the stroke."""
    errors = [part["errors"]["full"]["corrected"] for part in parts if part["part"] == course]
    return max((abs(100 * error["greatest"]) for error in errors if error), default=None)


def measure(run):
    rows = tables.rows(run / "history.csv")
    report = json.loads((run / "run.json").read_text())
    stroke = max(row["volume"] for row in rows) - rows[0]["volume"]
    volume = max(abs(row["volume_error"]) for row in tables.rows(run / "solver.csv")) * rows[0]["volume"]
    verified = json.loads((run.parent / f"{run.name}.verify" / "verify.json").read_text())
    shape = verified["finite_elements"]["shape_energy"]
    return {
        "unknowns": report["discretisation"]["unknowns"],
        "steps": report["steps"],
        "rising %": course_error(verified["parts"], "rising"),
        "holding %": course_error(verified["parts"], "holding"),
        "falling %": course_error(verified["parts"], "falling"),
        "shape %": 100 * shape["greatest_J"] / shape["greatest_elastic_J"],
        "volume error": volume / stroke,
    }


def main():
    folder, reference = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    recorded = json.loads(reference.read_text()) if reference.exists() else {"tolerance %": 3, "ends early": [], "runs": {}}
    found, failed = {}, 0
    for run in sorted(p for p in folder.iterdir() if (p / "run.json").exists()):
        if json.loads((run / "run.json").read_text())["status"] != "complete":
            expected = run.name in recorded["ends early"]
            print(f"{run.name}: ended early{', as recorded' if expected else ''}")
            failed += not expected
        elif (run.parent / f"{run.name}.verify" / "verify.json").exists():
            found[run.name] = measure(run)
    if not found:
        sys.exit("no complete run")
    names = list(next(iter(found.values())))
    print("| run | " + " | ".join(names) + " | |\n" + "|---" * (len(names) + 2) + "|")
    for name, values in found.items():
        was = recorded["runs"].get(name)
        courses = [key for key in names[2:5] if was and values[key] is not None]
        off = any(abs(values[key] - was[key]) > recorded["tolerance %"] for key in courses)
        failed += off
        shown = " | ".join("-" if v is None else f"{v:.3g}" if isinstance(v, float) else str(v) for v in values.values())
        print(f"| {name} | {shown} | {'OFF' if off else 'ok' if was else 'new'} |")
    if "--record" in sys.argv:
        recorded["runs"].update(found)
        reference.write_text(json.dumps(recorded, indent=1) + "\n")
    sys.exit(1 if failed else 0)


main()
