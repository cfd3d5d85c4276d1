"""The words of menus, where they stand elsewhere."""

import re


def plain(text: str) -> str:
    """Return a menu's words without mnemonic and dots; Japanese menus write the mnemonic behind them, as (&S)."""
    return re.sub(r"\s*\(&.\)", "", text).replace("&", "").replace("…", "")
