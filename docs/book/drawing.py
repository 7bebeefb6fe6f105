"""SVG in a form that WeasyPrint draws: `currentColor` replaced by the colour, and `use` by the named shape."""

import base64
import pathlib
from xml.etree import ElementTree

SVG = "{http://www.w3.org/2000/svg}"
LINK = "{http://www.w3.org/1999/xlink}href"


def plain(node, colour, named):
    """A copy of the node without references to colours and shapes."""
    colour = node.get("color", colour)
    attributes = {key: colour if value == "currentColor" else value for key, value in node.attrib.items() if key not in ("color", LINK)}
    used = named.get(node.get(LINK, "")) if node.tag == f"{SVG}use" else None
    copy = ElementTree.Element(node.tag if used is None else f"{SVG}g", attributes)
    copy.text, copy.tail = node.text, node.tail
    copy.extend(plain(child, colour, named) for child in (node if used is None else [used]) if child.tag != f"{SVG}defs")
    return copy


def address(path):
    """The address for an <img>: the converted drawing, or the file if WeasyPrint draws it unchanged."""
    path = pathlib.Path(path)
    if path.suffix != ".svg" or "currentColor" not in (text := path.read_text(encoding="utf-8")):
        return path.as_uri()
    tree = ElementTree.fromstring(text)
    named = {f"#{node.get('id')}": node for node in tree.iter() if node.get("id")}
    made = ElementTree.tostring(plain(tree, "black", named))
    return "data:image/svg+xml;base64," + base64.b64encode(made).decode()
