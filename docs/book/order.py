"""The order of the book: docs/book/order.toml."""

import pathlib
import tomllib

FILE = pathlib.Path(__file__).resolve().with_name("order.toml")


def parts():
    """(name, rows) of each part of the book; a row is path, name and purpose of a page."""
    return [(part["name"], part["pages"]) for part in tomllib.loads(FILE.read_text(encoding="utf-8"))["part"]]
