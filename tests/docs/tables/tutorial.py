"""Blocks of docs/tutorial.md."""

from .steps import Steps

STEPS = Steps("docs/tutorial.md", links=["hw"])
printed = STEPS.printed
folder = STEPS.folder
