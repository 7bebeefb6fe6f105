"""Sphinx: the pages of docs/ as a site. docs/book/book.py runs it."""

# pylint: disable=invalid-name
project = "csgsim"
root_doc = "index"
extensions = ["myst_parser"]
myst_enable_extensions = ["html_image"]
myst_heading_anchors = 6
highlight_language = "none"
smartquotes = False

html_theme = "furo"
html_title = "csgsim"
html_copy_source = False
html_show_copyright = False
html_show_sphinx = False
html_show_search_summary = False  # it is fetched, which no browser does from file://
html_domain_indices = False
html_use_index = False
html_static_path = ["book/site.css", "book/site.js"]
html_css_files = ["site.css"]
html_js_files = ["site.js"]
