"""The search of the site: an index of pages and headings as a script, which the browser ranks (search.js); both work from file://."""

import html.parser
import json
import pathlib
import re
import shutil

HERE = pathlib.Path(__file__).resolve().parent
SPHINX = ("_static/searchtools.js", "_static/language_data.js", "searchindex.js")
OURS = ("_static/search-data.js", "_static/search.js")


class Article(html.parser.HTMLParser):
    """The sections of a page: id, heading, terms that tables and lists define, prose, and other text (tables, listings)."""

    def __init__(self, text):
        super().__init__()
        self.sections, self.ids, self.heading, self.skipped, self.cells, self.defines, self.inside = [], [], None, 0, 0, False, 0
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        if tag == "section":
            self.ids.append(attributes.get("id", ""))
        elif re.fullmatch("h[1-6]", tag):
            self.heading = ""
            self.sections.append({"id": self.ids[-1] if self.ids else "", "heading": "", "terms": "", "text": "", "other": ""})
        elif tag == "a" and attributes.get("class") == "headerlink":
            self.skipped += 1
        elif tag == "tr":
            self.cells = 0
        elif tag == "td":
            self.cells += 1
            self.defines = self.cells == 1
        elif tag == "strong":
            self.defines = True
        if tag in ("table", "pre"):
            self.inside += 1
        if tag in ("p", "li", "td", "th", "pre", "tr") and self.sections:
            self.sections[-1][self.field()] += " "

    def field(self):
        return "other" if self.inside else "text"

    def handle_endtag(self, tag):
        if tag in ("table", "pre"):
            self.inside -= 1
        if tag == "section" and self.ids:
            self.ids.pop()
        elif re.fullmatch("h[1-6]", tag) and self.heading is not None:
            self.sections[-1]["heading"], self.heading = " ".join(self.heading.split()), None
        elif tag == "a" and self.skipped:
            self.skipped -= 1
        elif tag in ("td", "strong") and self.defines:
            self.sections[-1]["terms"] += " | "
            self.defines = False

    def handle_data(self, data):
        if self.skipped or not self.sections:
            return
        if self.heading is not None:
            self.heading += data
            return
        self.sections[-1][self.field()] += data
        if self.defines:
            self.sections[-1]["terms"] += data


def index(site, rows):
    """The pages of the site; a row is the path of a page in the site, its title and its subject."""
    pages = []
    for path, title, subject in rows:
        article = re.search(r'<article role="main">(.*?)</article>', (site / path).read_text(encoding="utf-8"), re.DOTALL)[1]
        sections = [{key: " ".join(value.split()) for key, value in section.items()} for section in Article(article).sections]
        pages.append({"path": path, "title": title, "subject": subject, "sections": sections})
    return pages


def write(site, rows):
    """Replaces Sphinx's search, which knows no weights of headings, in search.html."""
    data = json.dumps(index(site, rows), ensure_ascii=False, separators=(",", ":"))
    (site / OURS[0]).write_text(f"var pages = {data};\n", encoding="utf-8")
    shutil.copy(HERE / "search.js", site / OURS[1])
    page = site / "search.html"
    text = page.read_text(encoding="utf-8")
    for script in SPHINX:
        text, count = re.subn(rf'\s*<script src="{re.escape(script)}[^"]*"[^>]*></script>', "", text)
        if count != 1:
            raise ValueError(f"search.html has {script} {count} times")
    scripts = "".join(f'<script src="{script}"></script>\n' for script in OURS)
    page.write_text(text.replace("</body>", f"{scripts}</body>"), encoding="utf-8")
