"""Formulas as HTML, set by KaTeX while the pages are made: readers need neither scripts nor a network, and a formula that
KaTeX does not understand is a warning with its place."""

import json
import pathlib
import subprocess

from docutils import nodes
from sphinx.util import logging

KATEX = "/usr/share/javascript/katex/katex.js"
log = logging.getLogger(__name__)
process = None


def typeset(node, display):
    global process
    if process is None:
        script = pathlib.Path(__file__).with_name("formulas.js")
        process = subprocess.Popen(["node", script, KATEX], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    process.stdin.write(json.dumps({"tex": node.astext(), "display": display}) + "\n")
    process.stdin.flush()
    answer = json.loads(process.stdout.readline())
    if "error" in answer:
        log.warning("%s", answer["error"], location=node)
    return answer.get("html", "")


def visit_inline(writer, node):
    writer.body.append(typeset(node, False))
    raise nodes.SkipNode


def visit_block(writer, node):
    writer.body.append(f'<div class="formula">{typeset(node, True)}</div>')
    raise nodes.SkipNode


def setup(app):
    app.add_html_math_renderer("katex", (visit_inline, None), (visit_block, None))
    return {"parallel_read_safe": True, "parallel_write_safe": False}
