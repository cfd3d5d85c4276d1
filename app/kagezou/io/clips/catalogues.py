"""The catalogues of translations: one file a language, as Qt's tools write it, read here without Qt.

The window lets Qt read the compiled ones. What is read here is for the few places of the command line that give texts
in another language than English.
"""

import xml.etree.ElementTree as ET
from functools import cache
from typing import Final

from kagezou.locations import resource_folder
from kagezou.message import Translate

MESSAGES: Final = "Message"
"""The context of what the rooms below the window say."""


@cache
def messages_in(code: str) -> Translate:
    """Return what translates the texts of messages into a language; what is not in its catalogue stays English."""
    root = ET.parse(resource_folder() / "translations" / f"kagezou_{code}.ts").getroot()
    known = {
        (message.findtext("source", ""), message.findtext("comment", "")): message.findtext("translation", "")
        for context in root.iter("context")
        if context.findtext("name") == MESSAGES
        for message in context.iter("message")
    }
    return lambda text, about: known.get((text, about)) or text
