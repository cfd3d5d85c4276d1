"""The manual as a website in both languages, with references made from the program itself.

``python3 packaging/dev.py site`` calls it. Pages are those that the program shows; beside them stand references of all
properties, from their table, and of all commands, from what each says of itself, and the description of the project
file. Nothing of it is written twice.
"""

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from dev_site_commands import commands_page
from dev_site_project_file import in_japanese
from dev_site_properties import properties_page

ROOT: Final = Path(__file__).resolve().parents[1]
SITE: Final = ROOT / "packaging" / "site"
LANGUAGES: Final = {"en": "English", "ja": "日本語"}
_REFERENCES: Final = {"en": "References", "ja": "リファレンス"}


def write_pages(folder: Path, language: str) -> tuple[str, ...]:
    """Write what the website of a language is made of, and return the names of its pages in their order."""
    from PySide6.QtCore import QCoreApplication

    from kagezou.ui.help.pages import FIRST, pages_in, with_properties
    from kagezou.ui.system.language import Language
    from kagezou.ui.window.wiring.help import sections

    speaking = Language(QCoreApplication.instance() or QCoreApplication([]))
    speaking.speak(language)
    try:
        folder.mkdir(parents=True)
        pages = pages_in(language)
        texts = {name: with_properties(page.text, sections()) for name, page in pages.items()}
        texts["properties"] = "\n".join(properties_page(language))
        texts["commands"] = "\n".join(commands_page(language))
        texts["project-file"] = _project_file(language)
        texts[FIRST] += "".join(_contents(texts[FIRST], language))
        for name, text in texts.items():
            (folder / f"{name}.md").write_text(_scripts_named(text), encoding="utf-8")
    finally:
        speaking.fall_silent()
    return tuple(texts)


def _contents(first: str, language: str) -> Iterator[str]:
    """Yield what makes the list at the side: the chapters of the first page, and the references."""
    chapters = re.findall(r"^## (.+?)\n(.*?)(?=^## |\Z)", first, re.MULTILINE | re.DOTALL)
    for title, text in (*chapters, (_REFERENCES[language], "(properties.md)(commands.md)(project-file.md)")):
        names = "\n".join(dict.fromkeys(re.findall(r"\(([a-z-]+)\.md\)", text)))
        yield f"\n```{{toctree}}\n:hidden:\n:caption: {title}\n\n{names}\n```\n"


def _project_file(language: str) -> str:
    from kagezou.io.project.format import description

    return description() if language == "en" else in_japanese(description())


def _scripts_named(text: str) -> str:
    """Return a page whose links to example scripts lead to where the website has them."""
    return text.replace("](../scripts/", "](scripts/").replace("](../pictures/", "](pictures/")


def build(out: Path) -> None:
    """Make the website anew; subprocess.CalledProcessError where a page or a link is broken."""
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    sources = out.with_name(f"{out.name}-pages")
    for folder in (out, sources):
        shutil.rmtree(folder, ignore_errors=True)
    for language in LANGUAGES:
        write_pages(sources / language, language)
        for beside in ("pictures", "scripts"):
            shutil.copytree(ROOT / "docs" / beside, sources / language / beside)
        # Sphinx takes the words of its theme from there, and writes them down in its own form beside.
        shutil.copytree(SITE / "locales", sources / language / "locales")
        command = ["-m", "sphinx", "-q", "-W", "-b", "html", "-c", str(SITE), "-D", f"language={language}"]
        subprocess.run([sys.executable, *command, str(sources / language), str(out / language)], check=True)
    links = "".join(f'<li><a href="{code}/index.html">{name}</a></li>' for code, name in LANGUAGES.items())
    (out / "index.html").write_text(
        '<!doctype html><meta charset="utf-8"><title>Kagezou</title><script>location.replace((navigator.language'
        f'.startsWith("ja") ? "ja" : "en") + "/index.html")</script><ul>{links}</ul>\n',
        encoding="utf-8",
    )
    (out / ".nojekyll").write_bytes(b"")
    shutil.rmtree(sources)


if __name__ == "__main__":
    build(Path(sys.argv[1]) if sys.argv[1:] else ROOT / "build" / "site")
