"""Every message of the program, in every language, read without Qt: all its values stand in it, and no English."""

import re
import string

import pytest

import dev_translations
from kagezou.io.clips.catalogues import messages_in
from kagezou.locations import resource_folder
from kagezou.message import Message

FOLDER = resource_folder() / "translations"
FOREIGN = sorted({path.stem.removeprefix("kagezou_") for path in FOLDER.glob("kagezou_*.ts")} - {"en"})
SOURCES = sorted(dev_translations.messages())

_STAYS_ENGLISH = re.compile(r"pip install '[^']*'|\b(true|false|psd|exr|libegl1|libgl1|mesa|dri|pathmapping)\b")


def marked(text: str) -> dict[str, object]:
    """Return a value for each place of a text that can be found again in what is shown."""
    values: dict[str, object] = {}
    for _, name, form, _ in string.Formatter().parse(text):
        if name:
            values[name] = 7040.5 + len(values) if form else f"‹{name}›"
    return values


@pytest.mark.parametrize("code", FOREIGN)
@pytest.mark.parametrize("source", SOURCES, ids=lambda source: source[0][:60])
def test_every_message_is_shown_in_every_language_with_its_values(source: tuple[str, str], code: str) -> None:
    text, about = source
    values = marked(text)

    shown = Message(text, about, **values).formatted(messages_in(code))

    # As often as in English: a value that is said twice may be said once.
    for name, value in values.items():
        assert (str(value) if isinstance(value, str) else f"{value:g}"[:4]) in shown, name
    english = re.sub(r"\{\w+[^}]*\}|'[^']*'|\"[^\"]*\"", "", _STAYS_ENGLISH.sub("", text))
    words = [word for word in re.findall(r"\b[a-z]{4,}\b", english) if word not in messages_in(code)(text, about)]
    assert not [word for word in words if word in re.sub("‹.*?›", "", shown)]
    if re.search(r"[a-z]{3} [a-z]", english):
        assert shown != Message(text, about, **values).formatted(lambda same, _: same)
