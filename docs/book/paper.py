"""The site as one PDF, by WeasyPrint: a cover, the contents with numbers of pages, and each part's pages."""

import html
import os
import pathlib
import re

import drawing

HERE = pathlib.Path(__file__).resolve().parent
ARTICLE = re.compile(r'<article role="main">(.*?)</article>', re.DOTALL)
TAG = re.compile(r"<[a-z][^>]*>")
ATTRIBUTE = re.compile(r'\b(id|href|src)="([^"]*)"')
TABLE = re.compile(r"<table[^>]*>(.*?)</table>", re.DOTALL)
ROW = re.compile(r"<tr[^>]*>(.*?)</tr>", re.DOTALL)
CELL = re.compile(r"<t[hd][^>]*>(.*?)</t[hd]>", re.DOTALL)
LINE_LETTERS = 112  # characters of a table row that fit on a line
CELL_LETTERS = (10, 48)  # minimum and maximum width of a column, characters


def name_of(page, anchor=""):
    """The identifier in the book of a page's anchor."""
    return re.sub(r"\W", "-", page.removesuffix(".html")) + (f"--{anchor}" if anchor else "")


def is_elsewhere(target):
    return re.match(r"[a-z]+:", target) is not None


class Page:
    """A page of the site, and its content in the book."""

    def __init__(self, site, path, known):
        self.site, self.path, self.known = site, path, known

    def attribute(self, found):
        key, value = found.groups()
        if key == "id":
            return f'id="{name_of(self.path, value)}"'
        if is_elsewhere(value):
            return found[0]
        target, _, anchor = value.partition("#")
        path = os.path.normpath(os.path.join(os.path.dirname(self.path), target)) if target else self.path
        if key == "src":
            return f'src="{drawing.address(self.site / path)}"'
        return f'href="#{name_of(path, anchor)}"' if path in self.known else "data-no-page"

    def content(self):
        body = ARTICLE.search((self.site / self.path).read_text(encoding="utf-8"))[1]
        body = TAG.sub(lambda tag: ATTRIBUTE.sub(self.attribute, tag[0]), body)
        return TABLE.sub(divided, body.replace("<details", "<details open"))


def plain(text):
    return html.unescape(re.sub(r"<[^>]*>", "", text)).strip()


def divided(table):
    """Adds column widths, by the longest cells, to a table wider than a line; WeasyPrint's own widths are worse."""
    rows = [[len(plain(cell)) for cell in CELL.findall(row)] for row in ROW.findall(table[1])]
    letters = [max(column) for column in zip(*rows)]
    if "<img" in table[1] or sum(letters) <= LINE_LETTERS:
        return table[0]
    letters = [min(CELL_LETTERS[1], max(CELL_LETTERS[0], each)) for each in letters]
    columns = "".join(f'<col style="width: {100 * each / sum(letters):.1f}%">' for each in letters)
    return f'<table class="divided"><colgroup>{columns}</colgroup>{re.sub("<colgroup>.*?</colgroup>", "", table[1], flags=re.DOTALL)}</table>'


def contents(parts):
    rows = ""
    for number, (name, pages) in enumerate(parts):
        rows += f'<li class="part"><a href="#part-{number}">{name}</a></li>'
        rows += "".join(f'<li><a href="#{name_of(path)}">{html.escape(title)}</a></li>' for path, title in pages)
    return f'<nav><p class="head">Contents</p><ul>{rows}</ul></nav>'


def book(site, parts):
    """The HTML of the whole book; parts are (name, [(page, title)])."""
    known = {path for _, pages in parts for path, _ in pages}
    body = ""
    for number, (name, pages) in enumerate(parts):
        body += f'<div class="part" id="part-{number}">{name}</div>'
        for path, _ in pages:
            body += f'<article id="{name_of(path)}">{Page(site, path, known).content()}</article>'
    cover = (f'<div class="cover"><p class="name">csgsim</p><p>The logic-enhanced frame buffers of the 1980s,<br>'
             f'clock by clock</p><img src="{next((site / "_images").glob("vehicle*.png")).as_uri()}"></div>')
    style = (HERE / "paper.css").read_text(encoding="utf-8")
    return f'<html lang="en"><head><title>csgsim</title><style>{style}</style></head><body>{cover}{contents(parts)}{body}</body></html>'


def make(site, parts):
    """Writes the pages of SITE to csgsim.pdf beside it."""
    import weasyprint  # pylint: disable=import-outside-toplevel  # not needed for the site

    pages = [(name, [(page.removesuffix(".md") + ".html", title) for page, title in rows]) for name, rows in parts]
    weasyprint.HTML(string=book(site, pages), base_url=str(site)).write_pdf(str(site.with_name("csgsim.pdf")))
