"""The Python package by CMake: see python/CMakeLists.txt."""

import re
import sys
from pathlib import Path

from skbuild import setup

version = re.search(r"project\(turgor VERSION ([\d.]+)", Path("CMakeLists.txt").read_text())[1]

setup(
    name="turgor",
    version=version,
    description="Liquid-filled hyperelastic balloons",
    license="MIT",
    packages=["turgor"],
    package_dir={"": "python"},
    package_data={"turgor": ["py.typed", "*.pyi"]},
    python_requires=">=3.11",
    install_requires=["numpy"],
    extras_require={"all": ["matplotlib", "pandas", "scipy", "tqdm", "xarray", "netcdf4"]},
    cmake_install_dir="python",
    cmake_install_target="install-python",
    cmake_args=["-DTURGOR_PYTHON=ON", "-DTURGOR_TESTS=OFF", "-DTURGOR_PYTHON_DIR=.", f"-DPython_EXECUTABLE={sys.executable}"],
)
