"""The sources of each room, read from its CMakeLists.txt, and the sources that CMake generates."""
import re
import subprocess
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]


def write(path, text):
    """Writes the file only if it changes, to avoid recompilation."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def words_of(cmake, name):
    return re.search(rf"set\({name} ([^)]*)\)", (TOP / cmake).read_text()).group(1).split()


def filled(template, values):
    """Returns the output of configure_file."""
    text = (TOP / template).read_text()
    for name, value in values.items():
        text = text.replace(f"@{name}@", value)
    if lacking := re.search(r"^@(\w+)@", text, re.MULTILINE):
        raise SystemExit(f"{template} needs {lacking.group(1)}, which sim/web/rooms.py does not provide")
    return text


def make_rows(folder, output, headers, namespace, kind, function, names):
    """Writes the output of csgsim_rows."""
    write(folder / output, filled("cmake/rows.cpp.in", {
        "includes": "".join(f'#include "{header}"\n' for header in headers),
        "declarations": "".join(f"extern const {kind} {name};\n" for name in names if "::" not in name),
        "rows": "".join(f"    &{name},\n" for name in names),
        "namespace": namespace, "type": kind, "function": function}))


def make_calls(cmake, folder, words=None):
    """Writes the output of each csgsim_rows and csgsim_embed call in a CMakeLists.txt; words are the values of its lists."""
    text = re.sub(r"\$\{(\w+)\}", lambda name: (words or {}).get(name.group(1), name.group(0)), (TOP / cmake).read_text())
    for output, headers, namespace, kind, function, names in re.findall(r'^csgsim_rows\((\S+) "?([^" ]+)"? (\S+) (\S+) (\S+)\s+([^)]*)\)', text, re.MULTILINE):
        make_rows(folder, output, headers.split(";"), namespace, kind, function, names.split())
    for output, header, namespace, function, place, names in re.findall(r"^csgsim_embed\((\S+) (\S+) (\S+) (\S+) (\S+)\s+([^)]*)\)", text, re.MULTILINE):
        texts = {name: ((TOP / cmake).parent / place / f"{name}.toml").read_text() for name in names.split()}
        write(folder / output, filled("cmake/embedded.cpp.in", {
            "header": header, "namespace": namespace, "function": function,
            "rows": "".join(f'    {{"{name}", R"toml({text})toml"}},\n' for name, text in texts.items())}))


def make_sources(made):
    """Writes to made/ROOM/ the sources that CMake generates in the build folder."""
    kinds, machines = (words_of("hw/kinds/CMakeLists.txt", name) for name in ("kinds", "machines"))
    make_calls("hw/kinds/CMakeLists.txt", made / "kinds", {
        "headers": ";".join(f"hw/{kind}/kind.h" for kind in kinds), "rows": " ".join(f"{kind}::kind" for kind in kinds),
        "makers": " ".join(f"{kind}_maker" for kind in kinds), "machines": " ".join(machines)})
    make_calls("hw/processors/CMakeLists.txt", made / "processors")
    make_calls("host/effects/CMakeLists.txt", made / "effects")
    scripts = words_of("sim/report/CMakeLists.txt", "page_scripts")
    texts = {"CSGSIM_" + script.replace(".", "_"): (TOP / "sim/report" / script).read_text() for script in scripts}
    write(made / "report/text.cpp", filled("sim/report/text.cpp.in", {
        "CSGSIM_PAGE_STYLE": (TOP / "sim/report/page.css").read_text(), **texts}))
    (made / "session").mkdir(parents=True, exist_ok=True)
    subprocess.run(["cmake", f"-DSOURCE={TOP}", f"-DOUTPUT={made}/session/commit.cpp", "-P", TOP / "cmake/commit.cmake"],
                   check=True)


def sources_of(room, made):
    """Returns the files of a csgsim_library, both from its folder and generated."""
    for cmake in [*TOP.glob("h*/*/CMakeLists.txt"), *TOP.glob("sim/*/CMakeLists.txt")]:
        text = re.sub(r"#.*", "", cmake.read_text())
        found = re.search(rf"csgsim_library\({room}\s+SOURCES\s+([^()]*)", text)
        if found is None:
            continue
        words = re.split(r"\b(?:LINK|PRIVATE_LINK)\b", found.group(1))[0].split()
        return [made / room / Path(word).name if word.startswith("$") else cmake.parent / word for word in words]
    raise SystemExit(f"there is no room {room}")


def version():
    return re.search(r"project\(csgsim VERSION ([\d.]+)", (TOP / "CMakeLists.txt").read_text()).group(1)
