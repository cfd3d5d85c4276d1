"""By what a widget that is loaded late tells which page of the manual is about it."""

from typing import Final

PAGE: Final = "manual_page"
"""The Qt property that holds the page's name."""
