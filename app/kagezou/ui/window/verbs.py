"""What the connections may ask of the window as a whole."""

from typing import Protocol


class WindowVerbs(Protocol):
    """The window, as far as its parts need it."""

    def show_title(self) -> None:
        """Show the project's name, and whether it is saved."""

    def show_page(self) -> None:
        """Show the picture, or where to begin while there is none."""

    def show_handles(self) -> None:
        """Show the handles if they are wanted."""

    def show_full_screen(self, on: bool) -> None:
        """Fill the screen, or go back."""

    def choose_language(self, code: str) -> None:
        """Take note that another language is wanted; "" is the system's."""

    def close(self) -> bool:
        """Close, unless unsaved work shall be kept."""
