#!/usr/bin/env python3
"""Compiles the session of csgsim view to WebAssembly, beside CMake: build.py FOLDER CLIPPER makes FOLDER/csgsim.wasm.

CLIPPER names clipper.cpp of Debian's source package libpolyclipping, whose library is for this machine alone. The
sources are those that the rooms' CMakeLists.txt name, but what asks the system for something that a page has not; what
the others need of that is in wasm/ and lacking/. ./setup.sh web installs what this needs.
"""
import subprocess
import sys
from pathlib import Path

from rooms import TOP, make_sources, sources_of, version, write

HERE = Path(__file__).resolve().parent
EMSCRIPTEN = Path("/usr/share/emscripten/system/lib")

# Rooms in which nothing takes time as it runs are compiled for size.
SLOW_ROOMS = "debug story swept commands plots report shell viewer".split()
ROOMS = """base toml isa machines division processors host pixel_planes scan_line pixel_square multi_processor kinds
model view facet csg scene lighting convex emit effects functional observe read flat solids judges reference checkpoint
lockstep""".split() + SLOW_ROOMS

# What asks for files, processes, shared libraries, or takes a library that is not headers alone.
LEFT_OUT = {
    "base": """child_guard child_process descriptor file_roles folder_lock input_file inputs_kept memory_file module
        output_file partial_files standard_streams""",
    "flat": "svg page shapes",
    "solids": "height_picture read_xml unzip",
    "plots": "files gnuplot",
    "report": "deflated",
    "shell": "finished_run frames levels run_outputs scad version manual_pages completion",
    "viewer": "door page recorded serve files",
}
# Files whose names are others' too.
ALONE = "quoting text_parse choice lane_kernels linear_kernels quadratic_kernels root_kernels".split()
BATCH = 8

FLAGS = """--target=wasm32-wasi -std=c++20 -DNDEBUG -D_LIBCPP_HARDENING_MODE=_LIBCPP_HARDENING_MODE_NONE
-fwasm-exceptions -msimd128 -mbulk-memory -msign-ext -mnontrapping-fptoint -ffp-contract=off
-DFMT_HEADER_ONLY -DBOOST_DISABLE_THREADS -D_WASI_EMULATED_SIGNAL
-D_LIBCPP_ENABLE_CXX17_REMOVED_UNARY_BINARY_FUNCTION -D_LIBCPP_ENABLE_CXX17_REMOVED_FEATURES
-DCGAL_DISABLE_GMP -DCGAL_HAS_NO_THREADS -DCGAL_NO_DEPRECATED_CODE -DCGAL_ALWAYS_ROUND_TO_NEAREST
-Wall -Wextra -Wconversion -Wsign-conversion -Wno-unused-command-line-argument""".replace("\n", " ")

COMMON = """algorithm array cmath cstdint filesystem functional limits map memory optional set span stdexcept string
string_view utility variant vector fmt/format.h""".split()
COMMON_OF = {"quick": [*COMMON, "glm/geometric.hpp"], "small": [*COMMON, "nlohmann/json.hpp"]}
OPTIMISED = {"quick": "-O2", "small": "-O2"}

# What wasm/session.cpp has for the page.
EXPORTS = "input output output_size keep begin answer".split()

# Of the memory at first and at most: past 2 GB differences of pointers would be negative.
FIRST_MEMORY = 1 << 26
MOST_MEMORY = 1 << 31
STACK = 1 << 23


def link_headers(out):
    """Libraries that are headers alone, without the system's other headers beside them."""
    include = out / "include"
    include.mkdir(parents=True, exist_ok=True)
    for name in "boost fmt tao toml++ nlohmann hwy glm polyclipping CLI".split():
        if not (include / name).exists():
            (include / name).symlink_to(f"/usr/include/{name}")
    # CGAL 5.5 names a base() that clang 19 misses.
    if not (include / "CGAL").exists():
        subprocess.run(["cp", "-rs", "/usr/include/CGAL", include / "CGAL"], check=True)
        iterator = include / "CGAL/boost/graph/iterator.h"
        text = iterator.read_text()
        iterator.unlink()
        write(iterator, text.replace("this->base() == nullptr", "g == nullptr"))
    # libc++ declares std::fstream only where there is a file system, which toml++ and CLI11 name.
    site = Path("/usr/include/wasm32-wasi/c++/v1/__config_site").read_text()
    write(include / "__config_site", site.replace("#define _LIBCPP_HAS_NO_FILESYSTEM", ""))


def batches_of(room, made):
    """Files that are compiled together, by a name."""
    left_out = LEFT_OUT.get(room, "").split()
    files = [file for file in sources_of(room, made) if file.stem not in left_out]
    apart = [file for file in files if file.stem in ALONE or room == "effects"]
    rest = [file for file in files if file not in apart]
    return {**{f"{room}_{i // BATCH}": rest[i:i + BATCH] for i in range(0, len(rest), BATCH)},
            **{f"{room}_{file.stem}": [file] for file in apart}}


def rules(out):
    compiler = f"clang++-19 {FLAGS} -isystem {out}/include -I{TOP} -DCSGSIM_VERSION='\"{version()}\"'"
    runtime = ("--target=wasm32-wasi -O2 -fwasm-exceptions -D__USING_WASM_EXCEPTIONS__ -DNDEBUG "
               f"-D_LIBCXXABI_HAS_NO_THREADS -D_LIBUNWIND_HAS_NO_THREADS -I{EMSCRIPTEN}/libunwind/include")
    return ["rule header", f"  command = {compiler} $more -x c++-header -MD -MF $out.d $in -o $out", "  depfile = $out.d",
            "  deps = gcc", "rule cc",
            f"  command = {compiler} $more -include-pch $pch -MD -MF $out.d -c $in -o $out", "  depfile = $out.d",
            "  deps = gcc", "  description = $in",
            "rule runtime", f"  command = $cc {runtime} $more -c $in -o $out",
            "rule link", "  command = clang++-19 --target=wasm32-wasi -fwasm-exceptions @$out.objects "
            "-lwasi-emulated-signal -mexec-model=reactor " + "".join(f"-Wl,--export=csgsim_{name} " for name in EXPORTS) +
            f"-Wl,--gc-sections,--strip-debug,-z,stack-size={STACK},--initial-memory={FIRST_MEMORY},--max-memory={MOST_MEMORY},--error-limit=0 -o $out",
            "  rspfile = $out.objects", "  rspfile_content = $in"]


def compiled(name, files, form, made, more=""):
    write(made / f"{name}.cpp", "".join(f'#include "{file}"\n' for file in files))
    return [f"build {name}.o: cc made/{name}.cpp | {form}.pch", f"  more = {OPTIMISED[form]}{more}",
            f"  pch = {form}.pch"]


def runtime_of_exceptions(made):
    """Emscripten's, whose sources Debian has: its libc++abi for WASI is compiled without exceptions."""
    unwind = (EMSCRIPTEN / "libunwind/src/Unwind-wasm.c").read_text()
    write(made / "unwind.c", unwind.replace("#include <threads.h>", "#define thread_local _Thread_local"))
    lines = ["build unwind.o: runtime made/unwind.c", "  cc = clang-19",
             f"  more = -fdeclspec -D__EMSCRIPTEN__ -I{EMSCRIPTEN}/libunwind/src"]
    abi = EMSCRIPTEN / "libcxxabi"
    for name in ("cxa_exception", "cxa_personality"):
        lines += [f"build {name}.o: runtime {abi}/src/{name}.cpp", "  cc = clang++-19 -std=c++20",
                  "  more = -D_LIBCPP_ENABLE_CXX17_REMOVED_UNEXPECTED_FUNCTIONS -D_LIBCPP_INLINE_VISIBILITY= "
                  f"-D_LIBCXXABI_BUILDING_LIBRARY -I{abi}/src -I{abi}/include"]
    return lines, ["unwind.o", "cxa_exception.o", "cxa_personality.o"]


def build_file(out, clipper):
    made = out / "made"
    lines = rules(out)
    for form, headers in COMMON_OF.items():
        write(made / f"{form}.h", f'#include "{HERE}/lacking/lacking.h"\n' + "".join(f"#include <{name}>\n"
                                                                                    for name in headers))
        lines += [f"build {form}.pch: header made/{form}.h", f"  more = {OPTIMISED[form]}"]
    objects = []
    for room in ROOMS:
        form = "small" if room in SLOW_ROOMS else "quick"
        for name, files in batches_of(room, made).items():
            lines += compiled(name, files, form, made, " -O3" if room == "functional" else "")
            objects.append(f"{name}.o")
    for file in sorted([*HERE.glob("wasm/*.cpp"), *HERE.glob("lacking/*.cpp")]):
        lines += compiled(f"web_{file.stem}", [file], "small", made)
        objects.append(f"web_{file.stem}.o")
    lines += compiled("clipper", [clipper], "quick", made, " -w")
    more, runtime = runtime_of_exceptions(made)
    lines += more
    lines.append("build csgsim.wasm: link " + " ".join([*objects, "clipper.o", *runtime]))
    return "\n".join(lines) + "\n"


def main():
    out, clipper = (Path(argument).resolve() for argument in sys.argv[1:3])
    link_headers(out)
    make_sources(out / "made")
    write(out / "build.ninja", build_file(out, clipper))
    return subprocess.run(["ninja", "-C", str(out), *sys.argv[3:]], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
