#!/usr/bin/env python3
"""Checks of the files that make a release: files_test.py BUILD SOURCE WORK Class

Installed: the links of the installed pages. Versions: the version is the same everywhere. Lintian: the packages made
from the build folder have no errors and no warnings; skipped without lintian."""

import pathlib
import re
import shutil
import subprocess
import sys
import unittest

BUILD, SOURCE, WORK = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
LINK = re.compile(r'(?:\]\(|src=")([^)#"\s]+)(?:#[^)"]*)?[)"]')
FENCE = re.compile(r"^(```|    ).*?$", re.MULTILINE)


def run(*words):
    """Runs a program that must succeed; returns its output."""
    done = subprocess.run([str(word) for word in words], check=False, text=True, capture_output=True, cwd=WORK)
    if done.returncode != 0:
        raise AssertionError(f"{words}: {done.returncode}\n{done.stdout[-4000:]}{done.stderr[-4000:]}")
    return done.stdout


class Installed(unittest.TestCase):
    """The pages of an installed csgsim."""

    def test_links_of_installed_pages_lead_to_installed_files(self):
        run("cmake", "--install", BUILD, "--prefix", WORK / "prefix", "--component", "csgsim")
        pages = sorted((WORK / "prefix/share").rglob("*.md"))
        self.assertIn(WORK / "prefix/share/doc/csgsim/docs/shapes.md", pages)
        links, broken = 0, []
        for page in pages:
            for target in LINK.findall(FENCE.sub("", page.read_text(encoding="utf-8"))):
                if re.match(r"[a-z]+:", target):
                    continue
                links += 1
                if not (page.parent / target).exists():
                    broken.append(f"{page.relative_to(WORK)}: {target}")
        self.assertGreater(links, 300)
        self.assertEqual(broken, [])

    def test_installation_replaces_a_link_to_a_source_file_by_its_name(self):
        docs, data = WORK / "doc", WORK / "data"
        shutil.rmtree(docs, ignore_errors=True)
        for folder in (docs / "docs", data / "examples/models"):
            folder.mkdir(parents=True, exist_ok=True)
        (data / "examples/models/a.csg").touch()
        (docs / "docs/b.md").touch()
        page = docs / "docs/page.md"
        page.write_text("[code](../host/x.h); [a](../tests/models/a.csg) [b](b.md#c) [[d]](https://e.f)\n", encoding="utf-8")
        run("cmake", f"-DDOCS={docs}", f"-DDATA={data}", "-P", SOURCE / "cmake/install_docs.cmake")
        self.assertEqual(page.read_text(encoding="utf-8"), "code (`host/x.h` in the source archive); "
                         "[a](../../data/examples/models/a.csg) [b](b.md#c) [[d]](https://e.f)\n")


class Versions(unittest.TestCase):
    """CMakeLists.txt has the version; other files repeat it."""

    def test_changelog_and_citation_have_the_version(self):
        def text(name):
            return (SOURCE / name).read_text(encoding="utf-8")

        version = re.search(r"project\(csgsim VERSION ([0-9.]+)", text("CMakeLists.txt"))[1]
        self.assertEqual(re.search(r"^## (\S+)", text("CHANGELOG.md"), re.MULTILINE)[1], version)
        self.assertEqual(re.search(r"^version: (\S+)", text("CITATION.cff"), re.MULTILINE)[1], version)
        for key in ("cff-version: 1.2.0", "message: ", "title: ", "authors:", "license: MIT"):
            self.assertRegex(text("CITATION.cff"), f"(?m)^{key}")


class Lintian(unittest.TestCase):
    """Debian's checker of packages."""

    def test_lintian_accepts_the_packages(self):
        shutil.rmtree(WORK / "packages", ignore_errors=True)
        run("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", WORK / "packages", "-D",
            "CPACK_PACKAGING_INSTALL_PREFIX=/usr")
        packages = sorted((WORK / "packages").glob("*.deb"))
        self.assertGreaterEqual(len(packages), 2)
        # These two are about folders of libraries: lib here, lib/ARCHITECTURE in the preset `package`.
        tags = "maintscript-calls-ldconfig,pkg-config-unavailable-for-cross-compilation"
        print(run("lintian", "--fail-on", "error,warning", "--allow-root", "--suppress-tags", tags, *packages))


if __name__ == "__main__":
    if sys.argv[4] == "Lintian" and not (shutil.which("lintian") and shutil.which("dpkg-shlibdeps")):
        print("lintian or dpkg-dev is not installed")
        sys.exit(77)
    WORK.mkdir(parents=True, exist_ok=True)
    unittest.main(argv=[sys.argv[0], sys.argv[4]], verbosity=2)
