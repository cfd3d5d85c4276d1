"""How Sphinx makes the website; the language is given on its command line."""

from pygments.lexers.special import TextLexer
from sphinx.application import Sphinx

project = "Kagezou"
author = "Kagezou"
extensions = ["myst_parser"]
myst_heading_anchors = 3
html_theme = "furo"
html_title = "Kagezou"
html_show_sphinx = False
html_show_copyright = False
html_copy_source = False
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#3b5b8c", "color-brand-content": "#3b5b8c"},
    "dark_css_variables": {"color-brand-primary": "#9db8e6", "color-brand-content": "#9db8e6"},
}
html_static_path = ["static"]
html_css_files = ["kagezou.css"]


def setup(app: Sphinx) -> None:
    """Show commands plain: to a shell the ``set`` of ``kagezou set`` and what is before ``=`` are something else."""
    app.add_lexer("sh", TextLexer)
