"""Puts together what Sphinx reads: pages.py TURGOR FOLDER

FOLDER/source has the pages that are in the repository, where they are in the repository, so that their links hold, and those
that are made here: reference, recorded numbers, cases beside their pictures. FOLDER/doxygen has the comments of the headers,
FOLDER/static what the pages load.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import textwrap
import types
import urllib.parse

import yaml

ROOT = pathlib.Path(__file__).resolve().parents[2]
WIDTH = 90  # characters of a line of help
SHOWN = ("briefdescription detaileddescription innerclass func typedef enum var public-type public-func public-static-func "
         "public-attrib public-static-attrib")
KATEX = pathlib.Path("/usr/share/javascript/katex")


def fenced(text, language=""):
    return f"```{language}\n{text.rstrip()}\n```\n"


def row(cells):
    return "| " + " | ".join(str(cell).replace("|", "\\|") for cell in cells) + " |\n"


def table(head, rows):
    return row(head) + row(["---"] * len(head)) + "".join(map(row, rows)) + "\n"


def python_reference():
    """Every public name of the package by autodoc."""
    import turgor

    def directive(name):
        thing = getattr(turgor, name)
        if isinstance(thing, types.ModuleType):
            return 2, f".. automodule:: turgor.{name}\n   :members:\n\n"
        if isinstance(thing, type):
            return 0, f".. autoclass:: turgor.{name}\n   :members:\n\n"
        return (1, f".. autofunction:: turgor.{name}\n\n") if callable(thing) else (
            3, f".. autodata:: turgor.{name}\n   :no-value:\n\n")

    return "Python reference\n================\n\n" + "".join(text for _, text in sorted(map(directive, turgor.__all__)))


def toctree(pages, *options):
    return "```{toctree}\n" + "".join(f":{option}:\n" for option in options) + "\n" + "\n".join(pages) + "\n```\n"


class Site:
    def __init__(self, program, folder):
        self.program = program.resolve()
        self.folder = folder.resolve()
        self.source = self.folder / "source"

    def turgor(self, *words):
        answer = subprocess.run([self.program, *words], capture_output=True, text=True)
        return answer.stdout if answer.returncode == 0 else answer.stderr or answer.stdout

    def write(self, path, text):
        """Writes a page when it is another one than before, since Sphinx goes by its time."""
        file = self.source / path
        file.parent.mkdir(parents=True, exist_ok=True)
        self.kept.add(file)
        if not file.exists() or file.read_text() != text:
            file.write_text(text)

    def copy(self, path, text=None):
        if text is not None:
            return self.write(path, text)
        file = self.source / path
        file.parent.mkdir(parents=True, exist_ok=True)
        self.kept.add(file)
        shutil.copy2(ROOT / path, file)

    def make(self):
        self.kept = set()
        self.write("index.md", (ROOT / "docs/site/index.md").read_text())
        self.committed()
        self.python()
        self.gallery()
        self.recorded()
        self.benchmarks()
        self.decisions()
        self.citing()
        self.keys()
        self.commands()
        self.write("reference/materials.md", "# Materials\n\n`turgor materials` prints:\n\n" + fenced(self.turgor("materials")))
        self.interface()
        for file in self.source.rglob("*"):
            if file.is_file() and file not in self.kept:
                file.unlink()
        self.static()

    def committed(self):
        """Pages and pictures as they are; the overviews that GitHub shows are not pages of the site."""
        listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "*.md", "*.png"], cwd=ROOT,
                                capture_output=True, text=True, check=True)
        elsewhere = ("README.md", "docs/README.md", "tests/", "docs/site/", "docs/gallery/README.md", "docs/benchmarks.md",
                     "docs/python/index.md")
        for path in listed.stdout.split():
            if path.endswith(".md") and not path.startswith("docs/site/"):
                check_links(path)
            if not path.startswith(elsewhere) and not re.fullmatch(r"verification/.+/README.md", path):
                self.copy(path)

    def python(self):
        """The pages of the Python package: all that there are, below their index."""
        pages = sorted(page.stem for page in (ROOT / "docs/python").glob("*.md") if page.stem != "index")
        notebooks = [self.notebook(path) for path in sorted((ROOT / "examples/notebooks").glob("*.ipynb"))]
        self.write("docs/python/reference.rst", python_reference())
        self.write("docs/python/index.md", (ROOT / "docs/python/index.md").read_text() + "\n" +
                   toctree([*pages, *notebooks, "reference"], "hidden"))

    def notebook(self, path):
        """A notebook with what it prints and draws; where it is as seen from the index of the Python pages."""
        folder = self.source / "docs/python/notebooks"
        command = ["jupyter-nbconvert", "--to", "markdown", "--execute", "--log-level", "ERROR", "--output-dir", folder, path]
        python = "/usr/lib/python3/dist-packages:" + os.environ.get("PYTHONPATH", "")
        subprocess.run(command, check=True, env=os.environ | {"PYTHONPATH": python, "PYDEVD_DISABLE_FILE_VALIDATION": "1"})
        self.kept |= {folder / f"{path.stem}.md", *(folder / f"{path.stem}_files").glob("*")}
        return f"notebooks/{path.stem}"

    def gallery(self):
        """The gallery with every case file below the picture that is made from it."""
        text = (ROOT / "docs/gallery/README.md").read_text()

        def with_cases(match):
            names = re.findall(r"`([^`]+\.toml)`", match[2])
            files = [fenced((ROOT / "cases" / name).read_text(), "toml") for name in names]
            return match[0] + "".join(f"\n<details><summary>{name}</summary>\n\n{file}\n</details>\n"
                                      for name, file in zip(names, files))

        self.write("docs/gallery/README.md", re.sub(r"^(`turgor figure .*?) · cases (.*?)$", with_cases, text, flags=re.M))

    def recorded(self):
        """Every study with its recorded numbers."""
        studies = sorted(folder.parent for folder in (ROOT / "verification").glob("*/README.md"))
        self.write("verification/README.md", (ROOT / "verification/README.md").read_text() + "\n" +
                   toctree([f"{study.name}/README" for study in studies], "hidden"))
        for study in studies:
            text = (study / "README.md").read_text()
            reference = study / "reference.json"
            if reference.exists():
                text += "\n## Recorded numbers\n\n" + numbers(json.loads(reference.read_text()))
            self.write(f"verification/{study.name}/README.md", text)

    def benchmarks(self):
        """The page of benchmarks with what `./dev bench` has recorded on this machine, if it has."""
        text = (ROOT / "docs/benchmarks.md").read_text() + "\n## Recorded on the machine that made these pages\n\n"
        record = ROOT / "build/bench/bench.json"
        if record.exists():
            text += fenced(record.read_text(), "json")
        else:
            text += "Nothing: `./dev bench` has not run there.\n"
        self.write("docs/benchmarks.md", text)

    def decisions(self):
        notes = sorted((ROOT / "docs/decisions").glob("[0-9]*.md"))
        self.write("docs/decisions/index.md", "# Decisions\n\nWhy things are as they are, with what was measured "
                   "and what else there was.\n\n" + toctree([note.stem for note in notes], "titlesonly"))

    def citing(self):
        facts = yaml.safe_load((ROOT / "CITATION.cff").read_text())
        paper = facts["references"][0]
        names = " and ".join(f"{author['family-names']}, {author['given-names']}" for author in paper["authors"])
        self.write("citing.md", f"# Citing\n\n{facts['message']}\n\n" + fenced(
            f"@article{{ilssar-gat,\n  title = {{{paper['title']}}},\n  author = {{{names}}},\n  journal = {{{paper['journal']}}},\n"
            f"  note = {{{paper['identifiers'][0]['value']}}},\n  url = {{{paper['url']}}}\n}}\n\n"
            f"@software{{turgor,\n  title = {{{facts['title']}: {facts['abstract'].rstrip('.')}}},\n"
            f"  author = {{{{{facts['authors'][0]['name']}}}}},\n  version = {{{facts['version']}}}\n}}", "bibtex") +
            f"\nThe same for programs, `CITATION.cff`:\n\n{fenced((ROOT / 'CITATION.cff').read_text(), 'yaml')}")

    def keys(self):
        """Every key of a case file, by its table, as the program itself lists them."""
        tables = {}
        for key in json.loads(self.turgor("doc", "--json")):
            name, _, _ = key["key"].rpartition(".")
            tables.setdefault(name.split(".")[0], []).append(key)
        text = "# All keys\n\nWhat `turgor doc` prints. [Case files](../docs/case-files.md) explains them.\n\n"
        for name, keys in tables.items():
            text += f"## {'[' + name + ']' if name else 'At the top'}\n\n" + table(
                ("key", "unit", "default", "allowed", "meaning"),
                [(f"`{key['key']}`", "" if key["unit"] == "1" else key["unit"],
                  "required" if key["required"] else key["default"],
                  ", ".join(f"`{choice}`" for choice in key["choices"]) or ("" if key["range"] == "any" else key["range"]),
                  escaped(key["meaning"]) + (f" ({key['only_with_material']})" if key["only_with_material"] else "")) for key in keys])
        self.write("reference/keys.md", text)

    def commands(self):
        """The help of every command, and of the commands within."""
        text = "# All commands\n\nWhat each says with `--help`; the same is in the man page, `man turgor`.\n\n"

        def chapter(words, level):
            help_text = self.turgor(*words, "--help")
            lines = "\n".join(textwrap.fill(line, WIDTH, subsequent_indent=" " * 30 if line.startswith("  ") else "")
                              for line in help_text.splitlines())
            found = f"{'#' * level} {' '.join(['turgor', *words])}\n\n{fenced(lines, 'text')}\n"
            inner = re.search(r"^Subcommands:\n((?:  .*\n)+)", help_text, re.M)
            for name in re.findall(r"^  (\w\S*)", inner[1], re.M) if inner else ():
                found += chapter([*words, name], min(level + 1, 4))
            return found

        self.write("reference/commands.md", text + chapter([], 2))

    def doxygen(self):
        """The comments of the headers as XML, made again when one of them has changed: all C++ pages are read again then."""
        output = self.folder / "doxygen"
        settings = ROOT / "docs/site/Doxyfile"
        names = ROOT / "docs/site/headers.sed"
        done = output / "xml/index.xml"
        if done.exists() and done.stat().st_mtime > max(
                file.stat().st_mtime for file in [*(ROOT / "include").rglob("*.hpp"), settings, names]):
            return
        output.mkdir(parents=True, exist_ok=True)
        places = (f"\nINPUT = {ROOT / 'include'}\nSTRIP_FROM_PATH = {ROOT / 'include'}\nOUTPUT_DIRECTORY = {output}\n"
                  f"INPUT_FILTER = \"sed -f {names}\"\n")
        subprocess.run(["doxygen", "-"], input=settings.read_text() + places, text=True, check=True)

    def interface(self):
        """One page for each room of include/turgor, from the comments in its headers."""
        self.doxygen()
        held = dict(re.findall(r"^\| (`.*?`) \| (.*?) \|$", (ROOT / "CONTRIBUTING.md").read_text(), re.M))
        about = {room: what for rooms, what in held.items() for room in re.findall(r"`(\w+)`", rooms)}
        rooms = sorted(folder.name for folder in (ROOT / "include/turgor").iterdir())
        for room in rooms:
            text = f"# {room}\n\n{about.get(room, '').capitalize()}.\n\n"
            for header in sorted((ROOT / "include/turgor" / room).glob("*.hpp")):
                text += f"## {header.name}\n\n`#include \"turgor/{room}/{header.name}\"`\n\n"
                text += f"```{{doxygenfile}} {header.relative_to(ROOT / 'include')}\n:sections: {SHOWN}\n```\n\n"
            self.write(f"reference/api/{room}.md", text)
        consumer = fenced((ROOT / "examples/consumer/CMakeLists.txt").read_text(), "cmake") + "\n" + fenced(
            (ROOT / "examples/consumer/main.cpp").read_text(), "cpp")
        self.write("reference/api/index.md", "# The C++ interface\n\n`cmake --install build/release` installs a library that "
                   "`find_package(turgor)` finds. Everything is in the namespace `turgor`, in SI units or dimensionless.\n\n" + consumer +
                   "\nThe headers, by the rooms of `include/turgor`; what each is for: "
                   "[Contributing](../../CONTRIBUTING.md#how-the-tree-is-laid-out).\n\n" + toctree(rooms, "titlesonly"))

    def static(self):
        """Style and fonts of the formulas, the style of the site."""
        target = self.folder / "static"
        shutil.rmtree(target, ignore_errors=True)
        (target / "katex/fonts").mkdir(parents=True)
        style = (KATEX / "katex.css").read_text()
        (target / "katex/katex.css").write_text(re.sub(r",\s*url\([^)]*\.(woff|ttf)\)\s*format\([^)]*\)", "", style))
        for font in (KATEX / "fonts").glob("*.woff2"):
            shutil.copy(font, target / "katex/fonts")
        shutil.copy(ROOT / "docs/site/site.css", target)


def check_links(path):
    """Stops at a link to a file that is not there, also on pages that are not part of the site, and at one to elsewhere that cannot be
    one; whether it answers is not asked, since nothing here needs a network."""
    text = re.sub(r"^```.*?^```", "", (ROOT / path).read_text(), flags=re.M | re.S)
    for link in re.findall(r"(?<!`)\]\(([^)\s#]+)[^)]*\)", text):
        parts = urllib.parse.urlsplit(link)
        if parts.scheme and (parts.scheme != "https" or "." not in (parts.hostname or "")):
            raise SystemExit(f"{path}: the link to {link} has no https:// and the name of a site")
        if not parts.scheme and not ((ROOT / path).parent / link).exists():
            raise SystemExit(f"{path}: there is no {link} to link to")


def escaped(text):
    """Text of the program as Markdown."""
    return re.sub(r"([\[\]*_<>])", r"\\\1", text)


def number(value):
    return f"{value:.6g}" if isinstance(value, float) else value if not isinstance(value, list) else ", ".join(map(str, value))


def short(text):
    """The text of a number with six digits, other text as it is."""
    try:
        return f"{float(text):.6g}"
    except ValueError:
        return text


def numbers(record):
    """A reference.json as tables: the panels of check.py, or tables within tables."""
    text = ""
    for name, value in record.items():
        if name == "panels":
            for panel, asked in value.items():
                rows = [(quantity, "; ".join(f"{key} {number(rule[key])}" for key in rule if key != "values"),
                         ", ".join(f"{number(found)} at {short(x)}" for x, found in rule.get("values", {}).items()))
                        for quantity, rule in asked["quantities"].items()]
                text += f"### {panel}\n\n" + table(("quantity", "asked of it", "recorded"), rows)
        elif not isinstance(value, dict):
            text += f"{escaped(name)}: {number(value)}\n\n"
        elif all(isinstance(inner, dict) for inner in value.values()):
            columns = list(dict.fromkeys(key for inner in value.values() for key in inner))
            text += f"### {escaped(name)}\n\n" + table(["", *columns], [
                [key, *(number(inner.get(column, "")) for column in columns)] for key, inner in value.items()])
        else:
            text += f"### {escaped(name)}\n\n" + table(("", "value"), [(key, number(inner)) for key, inner in value.items()])
    return text


if __name__ == "__main__":
    Site(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])).make()
