"""The tables of the pages, a file a page."""
