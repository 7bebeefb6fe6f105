"""Builds the wheel of the Python module: pip calls it (pyproject.toml, docs/python.md).

CMake builds the module in build/wheel-PYTHON, or in the folder named by the environment variable CSGSIM_BUILD, such as
build/release, where only what changed is built.
"""

import os
import pathlib
import re
import subprocess
import sys
import sysconfig

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.sdist import sdist
from setuptools.errors import ExecError, OptionError

SOURCE = pathlib.Path(__file__).resolve().parent
TARGETS = ["csgsim_python", "csgsim_pictures_module", "csgsim_text_module"]


def version():
    """The version of CMakeLists.txt, the only place that has it."""
    found = re.search(r"project\(csgsim VERSION ([0-9.]+)", (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8"))
    return found.group(1)


def cmake(*words):
    """Runs cmake, and stops with a hint if it fails."""
    try:
        subprocess.run(["cmake", *map(str, words)], cwd=SOURCE, check=True)
    except FileNotFoundError:
        raise ExecError("cmake is not installed; ./setup.sh build installs all packages that csgsim is built with") from None
    except subprocess.CalledProcessError as error:
        raise ExecError(f"cmake ended with {error.returncode}; ./setup.sh build installs all packages that csgsim is "
                        "built with") from None


def built_folder():
    """The build folder, configured for the running Python."""
    given = os.environ.get("CSGSIM_BUILD")
    if given:
        folder = SOURCE / given
        if not (folder / "CMakeCache.txt").exists():
            raise OptionError(f"CSGSIM_BUILD: {folder} is not a build folder; ./setup.sh build makes build/release")
        return folder
    folder = SOURCE / "build" / f"wheel-{sys.implementation.cache_tag}"
    cmake("-S", SOURCE, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCSGSIM_PRECOMPILE=ON",
          "-DCMAKE_UNITY_BUILD=ON", "-DCSGSIM_BUILD_TESTS=OFF", "-DCSGSIM_PYTHON=ON",
          f"-DCSGSIM_PYTHON_PROGRAM={sys.executable}")
    return folder


class BuildExtension(build_ext):
    """The extension and the modules that it loads on demand, installed by CMake's component `wheel`."""

    def run(self):
        if self.editable_mode or self.inplace:
            raise OptionError("csgsim cannot be installed in editable mode; build/release/python/python3 runs the module "
                              "of the build folder")
        folder = built_folder()
        cmake("--build", folder, "--target", *TARGETS)
        package = pathlib.Path(self.build_lib, "csgsim")
        cmake("--install", folder, "--component", "wheel", "--prefix", package.resolve())
        module = package / f"_csgsim{sysconfig.get_config_var('EXT_SUFFIX')}"
        if not module.exists():
            raise ExecError(f"{folder} is built for another Python than {sys.executable}; unset CSGSIM_BUILD")


class SourceArchive(sdist):
    """Not offered: the source archive is made from git."""

    def run(self):
        raise OptionError("make the source archive by ./setup.sh release; setuptools would leave out the C++ sources")


(SOURCE / "build").mkdir(exist_ok=True)
setup(
    version=version(),
    ext_modules=[Extension("csgsim._csgsim", sources=[])],
    cmdclass={"build_ext": BuildExtension, "sdist": SourceArchive},
    options={"egg_info": {"egg_base": "build"}},
)
