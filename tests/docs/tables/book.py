"""The table of contents in docs/README.md, in the order of the book."""

import sys

from figures import ruled
from runs import ROOT

sys.path.insert(0, str(ROOT / "docs/book"))
import order  # pylint: disable=wrong-import-position

CONTENTS = "docs/README.md"


def pages(_):
    rows = []
    for name, listed in order.parts():
        rows.append((f"**{name}**", ""))
        rows += [(f"[{title}]({path.removeprefix('docs/')})", purpose) for path, title, purpose in listed if path != CONTENTS]
    return ruled(("page", "subject"), rows, numbers_from=9)
