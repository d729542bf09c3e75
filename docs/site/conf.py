"""The documentation as a web site, by Sphinx: `./dev docs`. pages.py puts together the sources that this reads."""

import pathlib
import re
import sys

here = pathlib.Path(__file__).parent
root = here.parents[1]
sys.path.insert(0, str(here))

project = "Turgor"
author = "The Turgor developers"
copyright = author
version = release = re.search(r"project\(turgor VERSION (\S+)", (root / "CMakeLists.txt").read_text())[1]

extensions = ["myst_parser", "breathe", "formulas", "sphinx.ext.autodoc"]
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
suppress_warnings = ["myst.header"]  # pages such as the changelog skip levels of headings on purpose
exclude_patterns = ["**/_*"]

html_theme = "furo"
html_title = f"Turgor {release}"
html_math_renderer = "katex"
html_static_path = [str(root / "build/docs/static")]
html_css_files = ["katex/katex.css", "site.css"]
html_copy_source = False
html_show_sphinx = False
html_theme_options = {
    "light_css_variables": {"font-stack": "system-ui, sans-serif", "font-stack--monospace": "ui-monospace, monospace"},
}
pygments_style = "friendly"
highlight_language = "text"

breathe_projects = {"turgor": str(root / "build/docs/doxygen/xml")}
breathe_default_project = "turgor"
breathe_domain_by_extension = {"hpp": "cpp"}
breathe_show_include = False
cpp_id_attributes = ["nodiscard"]

nitpicky = True
# Names in C++ declarations that are no pages here: the standard library and others, template parameters, and turgor's own
# in declarations outside of the namespace that they are found from.
nitpick_ignore_regex = [("cpp:.*", ".*"), ("py:.*", ".*")]
