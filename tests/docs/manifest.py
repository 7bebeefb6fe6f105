"""The manifest: docs/manifest/*.toml, a file a page. docs/developing.md has its rules."""

import pathlib
import tomllib
from dataclasses import dataclass, field

from runs import ROOT

FOLDER = ROOT / "docs" / "manifest"
KEYS = {
    "block": {"name", "table", "command", "long", "measured"},
    "sentence": {"words", "holds", "long", "measured"},
    "picture": {"files", "table", "command", "long", "measured"},
    "script": {"command", "begin", "end", "files", "long", "measured"},
    "allowed": {"near", "section", "reason"},
}
REASONS = ("published", "definition", "tested", "history", "not covered")


class Wrong(Exception):
    """The manifest cannot be used as it is."""


@dataclass
class Entry:
    """Something that a command makes."""

    kind: str
    page: str
    keys: dict
    page_is_long: bool = False

    @property
    def is_long(self):
        return self.keys.get("long", self.page_is_long)

    @property
    def is_exact(self):
        return not self.keys.get("measured", False)

    def __str__(self):
        what = self.keys.get("name") or [*self.keys.get("files", []), *self.keys.get("words", []), *self.keys.get("holds", []), self.keys.get("command")][0]
        return f"{self.page}: {self.kind} '{what.strip()[:100]}'"


@dataclass
class Page:
    """A page's part of the manifest."""

    path: str
    let: dict
    entries: list = field(default_factory=list)
    allowed: list = field(default_factory=list)


def check_keys(file, kind, keys):
    for key in keys:
        if key not in KEYS[kind]:
            raise Wrong(f"{file}: [[{kind}]] has no key '{key}'; it has {', '.join(sorted(KEYS[kind]))}")
    if kind == "allowed" and (keys.get("reason", "").split(":")[0] not in REASONS or ("near" in keys) == ("section" in keys)):
        raise Wrong(f"{file}: [[allowed]] has 'near' or 'section', and a 'reason' that begins with one of {', '.join(REASONS)}")
    if kind in ("block", "picture") and ("table" in keys) == ("command" in keys):
        raise Wrong(f"{file}: [[{kind}]] {keys.get('name', '')} has a 'table' or a 'command'")


def read_page(path):
    file = path.relative_to(ROOT)
    try:
        text = tomllib.loads(path.read_text(encoding="utf-8"))
    except tomllib.TOMLDecodeError as error:
        raise Wrong(f"{file}: {error}") from None
    page = Page(text.pop("page"), text.pop("let", {}))
    page_is_long = text.pop("long", False)
    if not (ROOT / page.path).exists():
        raise Wrong(f"{file}: there is no page {page.path}")
    for kind, rows in text.items():
        if kind not in KEYS:
            raise Wrong(f"{file}: there is no '{kind}'; there are page, long, let, {', '.join(KEYS)}")
        for keys in rows:
            check_keys(file, kind, keys)
            if kind == "allowed":
                page.allowed.append(keys)
            else:
                page.entries.append(Entry(kind, page.path, keys, page_is_long))
    return page


def read(folder=FOLDER):
    return [read_page(path) for path in sorted(pathlib.Path(folder).glob("*.toml"))]
