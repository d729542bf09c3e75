"""Runs what the documentation shows: examples.py TURGOR SOURCE [PAGE...]

Every ```sh block that calls turgor runs in a folder of its page, with the cases at hand; every ```toml block is validated. Comments
above a block, one a line, say what else there is to know:

  <!-- not run: REASON -->        it takes finite elements, minutes or a build, or is no command
  <!-- saved as NAME -->          it becomes a file there, for the blocks below
  <!-- completed by cases/... -->  which case lends a fragment the tables that it lacks; else cases/orifice-30mm.toml
  <!-- needs: sweep -->           it is skipped where that command was not built
  <!-- output -->                 it is what the block above printed, <!-- last lines of the output --> the end of it

A block of commands that is neither run nor marked is a fault, and so is one that fails or does not print what is shown.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import tomllib

TURGOR = pathlib.Path(sys.argv[1]).resolve()
ROOT = pathlib.Path(sys.argv[2]).resolve()
LIMIT = 200  # seconds for a block, under sanitizers on a busy machine
MARKS = r"not run|saved as|completed by|needs|output|last lines of the output"
BLOCK = re.compile(r"^((?:<!-- [^\n]* -->\n)*)```(\w*)\n(.*?)^```$", re.M | re.S)
WHOLE = {"balloon", "material", "fluid", "inlet", "solve"}  # tables of a case that [pressure] or [motion] completes
APART = {"motion": ("pressure", "initial", "expect")}       # what a fragment excludes from the case that completes it


class Fault(Exception):
    pass


def toml(value):
    """A value as inline TOML."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(key)} = {toml(inner)}" for key, inner in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    return json.dumps(value)


def completed(text, case):
    """A fragment with the tables that it lacks."""
    fragment = tomllib.loads(text)
    if WHOLE <= fragment.keys():
        return text
    without = {name for key in fragment for name in APART.get(key, ())} | fragment.keys()
    lent = {key: value for key, value in tomllib.loads((ROOT / case).read_text()).items() if key not in without}
    return "".join(f"{key} = {toml(value)}\n" for key, value in lent.items()) + text


def marks_of(comments):
    marks = {}
    for comment in re.findall(r"<!-- (.*) -->", comments):
        found = re.fullmatch(rf"({MARKS})(?::? (.+))?", comment)
        if found:
            marks[found[1]] = found[2]
    return marks


class Page:
    def __init__(self, path):
        self.path = path
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="turgor-examples-"))
        shutil.copytree(ROOT / "cases", self.folder / "cases")
        self.printed = ""
        self.ran = 0
        self.skipped = []

    def turgor(self, command):
        path = f"{TURGOR.parent}:{os.environ['PATH']}"
        try:
            done = subprocess.run(["bash", "-euc", command], cwd=self.folder, capture_output=True, text=True, timeout=LIMIT,
                                  env=os.environ | {"PATH": path})
        except subprocess.TimeoutExpired:
            raise Fault(f"takes more than {LIMIT} s; mark it <!-- not run: ... -->")
        if done.returncode != 0:
            raise Fault(f"has exit code {done.returncode}:\n{done.stdout}{done.stderr}")
        return done.stdout

    def run(self, language, text, marks):
        if "not run" in marks:
            if not marks["not run"]:
                raise Fault("does not say why it is not run")
            return self.skipped.append(marks["not run"])
        if "saved as" in marks:
            self.save(marks["saved as"], language, text, marks)
        if language == "toml":
            self.save("block.toml", language, text, marks)
            self.turgor("turgor validate " + (marks.get("saved as") or "block.toml"))
        elif language == "sh":
            self.commands(text, marks)
        elif self.printed is not None and ("output" in marks or "last lines of the output" in marks):
            shown, printed = text.rstrip().splitlines(), self.printed.rstrip().splitlines()
            if shown != (printed if "output" in marks else printed[-len(shown):]):
                raise Fault("is not what is printed:\n" + self.printed)
        else:
            return
        self.ran += 1

    def save(self, name, language, text, marks):
        if language == "toml":
            text = completed(text, marks.get("completed by") or "cases/orifice-30mm.toml")
        (self.folder / name).write_text(text)

    def commands(self, text, marks):
        if not re.search(r"\bturgor\b", text):
            raise Fault("calls no turgor; mark it <!-- not run: ... -->")
        if "needs" in marks and not (TURGOR.parent / f"turgor-{marks['needs']}").exists():
            self.printed = None
            return self.skipped.append(f"there is no turgor {marks['needs']} in this build")
        self.printed = self.turgor(text)


def main():
    pages = [ROOT / name for name in sys.argv[3:]] or [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
    wrong = 0
    for path in pages:
        page, begin = Page(path), time.monotonic()
        text = path.read_text()
        for block in BLOCK.finditer(text):
            line = text.count("\n", 0, block.start(2)) + 1
            try:
                page.run(block[2], block[3], marks_of(block[1]))
            except (Fault, tomllib.TOMLDecodeError) as fault:
                wrong += 1
                print(f"{path.relative_to(ROOT)}:{line}: the block {fault}")
        shutil.rmtree(page.folder)
        if page.ran or page.skipped:
            print(f"{path.relative_to(ROOT)}: {page.ran} blocks in {time.monotonic() - begin:.1f} s"
                  + "".join(f"\n  not run: {reason}" for reason in page.skipped))
    return 1 if wrong else 0


sys.exit(main())
