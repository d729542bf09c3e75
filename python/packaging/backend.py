"""Builds the wheel: setuptools and scikit-build, those of Debian where they are, so that `pip install .` needs no network.

pip builds in an environment that hides installed packages; what Debian has installed is put back on the path, and only what
is missing is asked for.
"""

import importlib.util
import sys

DEBIAN = "/usr/lib/python3/dist-packages"
NEEDED = {"setuptools": "setuptools<70", "skbuild": "scikit-build", "wheel": "wheel", "pybind11": "pybind11>=2.10"}

if DEBIAN not in sys.path:
    sys.path.append(DEBIAN)


def get_requires_for_build_wheel(config_settings=None):
    return [requirement for module, requirement in NEEDED.items() if importlib.util.find_spec(module) is None]


def prepare_metadata_for_build_wheel(folder, config_settings=None):
    from setuptools import build_meta

    return build_meta.prepare_metadata_for_build_wheel(folder, config_settings)


def build_wheel(folder, config_settings=None, metadata=None):
    from setuptools import build_meta

    return build_meta.build_wheel(folder, config_settings, metadata)
