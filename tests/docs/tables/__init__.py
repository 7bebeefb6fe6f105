"""The tables of the pages, one file per page."""
