"""Whether docs/equations.md tells the truth about the tree: every equation of the paper has a row, every file is there, holds the
names that the row gives for it, and every test exists. Usage: equations.py SOURCE"""

import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1])
WANTED = [f"(2.{i})" for i in range(1, 27)] + [f"(3.{i})" for i in range(1, 23)] + ["(A1)", "(A2)", "(B)"]
VERDICTS = ("correct", "misprint")


def tests():
    found = set()
    for file in (ROOT / "tests").rglob("*.cpp"):
        found |= {".".join(name) for name in re.findall(r"^TEST(?:_F|_P)?\((\w+),\s*(\w+)\)", file.read_text(), re.M)}
    return found


def file_named(name):
    for folder in ("include/turgor", "."):
        if (ROOT / folder / name).is_file():
            return ROOT / folder / name
    return None


def faults(row, known):
    """In words, what is wrong with a row."""
    number, _, verdict, where, test = row
    files = {name: file_named(name) for name in re.findall(r"`([\w./]+\.[ch]pp)`", where)}
    for name in (name for name, file in files.items() if file is None):
        yield f"{number}: there is no file {name}"
    text = "\n".join(file.read_text() for file in files.values() if file)
    for name in re.findall(r"`(\w+)`", where):
        if not re.search(rf"\b{name}\b", text):
            yield f"{number}: {name} is not in {', '.join(files)}"
    named = re.findall(r"`(\w+\.\w+)`", test)
    if not files or not named:
        yield f"{number}: names no file or no test"
    for name in named:
        if name not in known:
            yield f"{number}: there is no test {name}"
    if not verdict.startswith(VERDICTS):
        yield f"{number}: the verdict \"{verdict}\" does not begin with one of {', '.join(VERDICTS)}"


def main():
    page = (ROOT / "docs/equations.md").read_text()
    rows = [[cell.strip() for cell in line.strip("|\n").split("|")] for line in page.splitlines() if line.startswith("| (")]
    known = tests()
    wrong = [fault for row in rows for fault in (faults(row, known) if len(row) == 5 else [f"{row[0]}: has not five columns"])]
    numbers = [number for row in rows for number in row[0].split(", ")]
    wrong += [f"{number}: has {numbers.count(number)} rows" for number in WANTED if numbers.count(number) != 1]
    wrong += [f"{number}: is no equation of the paper" for number in numbers if number not in WANTED]
    print("\n".join(wrong) or f"{len(numbers)} equations")
    return 1 if wrong else 0


sys.exit(main())
