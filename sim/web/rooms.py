"""Which sources the rooms have, as their CMakeLists.txt say, and those that CMake makes."""
import re
import subprocess
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]


def write(path, text):
    """Only where it says something else, so that nothing is compiled again."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def words_of(cmake, name):
    return re.search(rf"set\({name} ([^)]*)\)", (TOP / cmake).read_text()).group(1).split()


def filled(template, values):
    """What configure_file makes of it."""
    text = (TOP / template).read_text()
    for name, value in values.items():
        text = text.replace(f"@{name}@", value)
    if lacking := re.search(r"@(CSGSIM_\w+)@", text):
        raise SystemExit(f"{template} asks for {lacking.group(1)}, which sim/web/rooms.py does not give")
    return text


def embedded(folder, names):
    """What csgsim_embed makes of descriptions."""
    return "".join(f'    {{"{name}", R"toml({(TOP / folder / name).with_suffix(".toml").read_text()})toml"}},\n'
                   for name in names)


def make_rows(cmake, folder):
    """What csgsim_rows makes for each of its calls in a CMakeLists.txt."""
    calls = re.findall(r'^csgsim_rows\((\S+) "?([^" ]+)"? (\S+) (\S+) (\S+)\s+([^)]*)\)', (TOP / cmake).read_text(), re.MULTILINE)
    for output, headers, namespace, kind, function, names in calls:
        names = names.split()
        text = (TOP / "cmake/rows.cpp.in").read_text()
        for name, value in {"includes": "".join(f'#include "{header}"\n' for header in headers.split(";")),
                            "declarations": "".join(f"extern const {kind} {name};\n" for name in names if "::" not in name),
                            "rows": "".join(f"    &{name},\n" for name in names),
                            "namespace": namespace, "type": kind, "function": function}.items():
            text = text.replace(f"@{name}@", value)
        write(folder / output, text)


def make_sources(made):
    """Into made/ROOM/, what CMake writes into the build folder."""
    kinds, machines, costly = (words_of("hw/kinds/CMakeLists.txt", name)
                               for name in ("kinds", "machines", "costly_machines"))
    write(made / "kinds/rows.cpp", filled("hw/kinds/rows.cpp.in", {
        "CSGSIM_KIND_INCLUDES": "".join(f'#include "hw/{kind}/kind.h"\n' for kind in kinds),
        "CSGSIM_KIND_ROWS": "".join(f"    &{kind}::kind,\n" for kind in kinds),
        "CSGSIM_BUILT_IN_MACHINES": embedded("hw/machines", machines),
        "CSGSIM_COSTLY_MACHINES": ", ".join(f'"{name}"' for name in costly)}))
    processors = words_of("hw/processors/CMakeLists.txt", "processors")
    write(made / "processors/built_in.cpp", filled("hw/processors/built_in.cpp.in", {
        "CSGSIM_BUILT_IN_PROCESSORS": embedded("hw/processors", processors)}))
    scripts = words_of("sim/report/CMakeLists.txt", "page_scripts")
    make_rows("host/effects/CMakeLists.txt", made / "effects")
    texts = {"CSGSIM_" + script.replace(".", "_"): (TOP / "sim/report" / script).read_text() for script in scripts}
    write(made / "report/text.cpp", filled("sim/report/text.cpp.in", {
        "CSGSIM_PAGE_STYLE": (TOP / "sim/report/page.css").read_text(), **texts}))
    (made / "session").mkdir(parents=True, exist_ok=True)
    subprocess.run(["cmake", f"-DSOURCE={TOP}", f"-DOUTPUT={made}/session/commit.cpp", "-P", TOP / "cmake/commit.cmake"],
                   check=True)


def sources_of(room, made):
    """The files of a csgsim_library: those of its folder, and those that are made."""
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
