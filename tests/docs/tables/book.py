"""README.md: the list of pages, in the order of the book."""

import sys

from figures import ruled
from runs import ROOT

sys.path.insert(0, str(ROOT / "docs/book"))
import order  # pylint: disable=wrong-import-position


def pages(_):
    rows = []
    for name, listed in order.parts():
        rows.append((f"**{name}**", ""))
        rows += [(f"[{title}]({path})", purpose) for path, title, purpose in listed]
    return ruled(("page", "for"), rows, numbers_from=9)
