#!/usr/bin/env python3
"""Compiles the session of csgsim view to WebAssembly without CMake: build.py FOLDER CLIPPER builds FOLDER/csgsim.wasm.

CLIPPER names clipper.cpp of Debian's source package libpolyclipping, whose binary is for this computer only. The
sources are those listed in the CMakeLists.txt of the rooms, except files that need system services a page lacks;
wasm/ and lacking/ replace the parts that the remaining files use. ./setup.sh web installs the required packages.
"""
import subprocess
import sys
from pathlib import Path

from rooms import TOP, make_sources, sources_of, version, write

HERE = Path(__file__).resolve().parent
EMSCRIPTEN = Path("/usr/share/emscripten/system/lib")

ROOMS = """base toml isa machines division processors host pixel_planes scan_line pixel_square multi_processor bit_serial_memory kinds
model view facet csg scene lighting convex emit setup effects functional observe read flat solids judges reference checkpoint
lockstep swept commands""".split()
# Rooms whose files use JSON.
JSON_ROOMS = "debug story plots report session viewer".split()

# Sources that need files, processes, shared libraries or a compiled library.
LEFT_OUT = {
    "base": """descriptor file_roles input_file inputs_kept module output_file partial_files standard_streams""",
    "flat": "svg page shapes",
    "solids": "height_picture read_xml unzip",
    "plots": "files gnuplot",
    "observe": "animation",
    "session": "finished_run frame_pictures frames levels run_outputs scad scad_messages version",
    "viewer": "door page recorded serve files",
}
# Files whose names clash with those of other files in a batch.
ALONE = "quoting text_parse choice lane_kernels linear_kernels quadratic_kernels root_kernels".split()
BATCH = 8

FLAGS = """--target=wasm32-wasi -std=c++20 -O2 -DNDEBUG -D_LIBCPP_HARDENING_MODE=_LIBCPP_HARDENING_MODE_NONE
-fwasm-exceptions -msimd128 -mbulk-memory -msign-ext -mnontrapping-fptoint -ffp-contract=off
-DFMT_HEADER_ONLY -DBOOST_DISABLE_THREADS -D_WASI_EMULATED_SIGNAL
-D_LIBCPP_ENABLE_CXX17_REMOVED_UNARY_BINARY_FUNCTION -D_LIBCPP_ENABLE_CXX17_REMOVED_FEATURES
-DCGAL_DISABLE_GMP -DCGAL_HAS_NO_THREADS -DCGAL_NO_DEPRECATED_CODE -DCGAL_ALWAYS_ROUND_TO_NEAREST
-Wall -Wextra -Wno-unused-command-line-argument""".replace("\n", " ")

# Precompiled headers.
COMMON = """algorithm array cmath cstdint filesystem functional limits map memory optional set span stdexcept string
string_view utility variant vector fmt/format.h glm/geometric.hpp""".split()
PRECOMPILED = {"common": COMMON, "json": [*COMMON, "nlohmann/json.hpp"]}

# Functions of wasm/session.cpp that the page calls.
EXPORTS = "input output output_size keep begin answer".split()

# Initial and maximum memory; above 2 GB differences of pointers would be negative.
FIRST_MEMORY = 1 << 26
MOST_MEMORY = 1 << 31
STACK = 1 << 23


def link_headers(out):
    """Links header-only libraries into a folder without other system headers."""
    include = out / "include"
    include.mkdir(parents=True, exist_ok=True)
    for name in "boost fmt tao toml++ nlohmann hwy glm polyclipping".split():
        if not (include / name).exists():
            (include / name).symlink_to(f"/usr/include/{name}")
    # CGAL 5.5 calls base(), which clang 19 does not find.
    if not (include / "CGAL").exists():
        subprocess.run(["cp", "-rs", "/usr/include/CGAL", include / "CGAL"], check=True)
        iterator = include / "CGAL/boost/graph/iterator.h"
        text = iterator.read_text()
        iterator.unlink()
        write(iterator, text.replace("this->base() == nullptr", "g == nullptr"))
    # toml++ names std::fstream, which libc++ declares only if there is a file system.
    site = Path("/usr/include/wasm32-wasi/c++/v1/__config_site").read_text()
    write(include / "__config_site", site.replace("#define _LIBCPP_HAS_NO_FILESYSTEM", ""))


def batches_of(room, made):
    """Maps names of batches to the files that are compiled together."""
    left_out = set(LEFT_OUT.get(room, "").split())
    sources = sources_of(room, made)
    if strangers := left_out - {file.stem for file in sources}:
        raise SystemExit(f"{room} has no {', '.join(sorted(strangers))} to leave out")
    files = [file for file in sources if file.stem not in left_out]
    apart = [file for file in files if file.stem in ALONE or room == "effects"]
    rest = [file for file in files if file not in apart]
    return {**{f"{room}_{i // BATCH}": rest[i:i + BATCH] for i in range(0, len(rest), BATCH)},
            **{f"{room}_{file.stem}": [file] for file in apart}}


RULES = """
rule header
  command = {compiler} -x c++-header -MD -MF $out.d $in -o $out
  depfile = $out.d
  deps = gcc
rule cc
  command = {compiler} $more -include-pch $pch -MD -MF $out.d -c $in -o $out
  depfile = $out.d
  deps = gcc
  description = $in
rule runtime
  command = $cc --target=wasm32-wasi -O2 -fwasm-exceptions -D__USING_WASM_EXCEPTIONS__ -DNDEBUG $
    -D_LIBCXXABI_HAS_NO_THREADS -D_LIBUNWIND_HAS_NO_THREADS -I{emscripten}/libunwind/include $more -c $in -o $out
rule link
  command = clang++-19 --target=wasm32-wasi -fwasm-exceptions @$out.objects -lwasi-emulated-signal $
    -mexec-model=reactor {exports} -Wl,--gc-sections,--strip-all,-z,stack-size={stack} $
    -Wl,--initial-memory={first_memory},--max-memory={most_memory} -o $out
  rspfile = $out.objects
  rspfile_content = $in
"""


def rules(out):
    return RULES.format(
        compiler=f"clang++-19 {FLAGS} -isystem {out}/include -I{TOP} -DCSGSIM_VERSION='\"{version()}\"'",
        emscripten=EMSCRIPTEN, exports=" ".join(f"-Wl,--export=csgsim_{name}" for name in EXPORTS), stack=STACK,
        first_memory=FIRST_MEMORY, most_memory=MOST_MEMORY)


def compiled(name, files, headers, made, more=""):
    write(made / f"{name}.cpp", "".join(f'#include "{file}"\n' for file in files))
    return [f"build {name}.o: cc made/{name}.cpp | {headers}.pch", f"  more = {more}", f"  pch = {headers}.pch"]


def runtime_of_exceptions(made):
    """Builds Emscripten's exception runtime from Debian's sources, since libc++abi for WASI is compiled without exceptions."""
    unwind = (EMSCRIPTEN / "libunwind/src/Unwind-wasm.c").read_text()
    write(made / "unwind.c", unwind.replace("#include <threads.h>", "#define thread_local _Thread_local"))
    lines = ["build unwind.o: runtime made/unwind.c", "  cc = clang-19",
             f"  more = -fdeclspec -Wno-ignored-attributes -D__EMSCRIPTEN__ -I{EMSCRIPTEN}/libunwind/src"]
    abi = EMSCRIPTEN / "libcxxabi"
    for name in ("cxa_exception", "cxa_personality"):
        lines += [f"build {name}.o: runtime {abi}/src/{name}.cpp", "  cc = clang++-19 -std=c++20",
                  "  more = -D_LIBCPP_ENABLE_CXX17_REMOVED_UNEXPECTED_FUNCTIONS -D_LIBCPP_INLINE_VISIBILITY= "
                  f"-D_LIBCXXABI_BUILDING_LIBRARY -I{abi}/src -I{abi}/include"]
    return lines, ["unwind.o", "cxa_exception.o", "cxa_personality.o"]


def build_file(out, clipper):
    made = out / "made"
    lines = [rules(out)]
    for name, headers in PRECOMPILED.items():
        includes = "".join(f"#include <{header}>\n" for header in headers)
        write(made / f"{name}.h", f'#include "{HERE}/lacking/lacking.h"\n' + includes)
        lines.append(f"build {name}.pch: header made/{name}.h")
    objects = []
    for room in ROOMS + JSON_ROOMS:
        for name, files in batches_of(room, made).items():
            lines += compiled(name, files, "json" if room in JSON_ROOMS else "common", made,
                              "-O3" if room == "functional" else "")
            objects.append(f"{name}.o")
    for file in sorted([*HERE.glob("wasm/*.cpp"), *HERE.glob("lacking/*.cpp")]):
        lines += compiled(f"web_{file.stem}", [file], "json", made)
        objects.append(f"web_{file.stem}.o")
    lines += compiled("clipper", [clipper], "common", made, "-w")
    runtime_lines, runtime = runtime_of_exceptions(made)
    lines += [*runtime_lines, "build csgsim.wasm: link " + " ".join([*objects, "clipper.o", *runtime])]
    return "\n".join(lines) + "\n"


def main():
    out, clipper = (Path(argument).resolve() for argument in sys.argv[1:3])
    link_headers(out)
    make_sources(out / "made")
    write(out / "build.ninja", build_file(out, clipper))
    return subprocess.run(["ninja", "-C", str(out), *sys.argv[3:]], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
