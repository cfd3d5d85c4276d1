"""An example of a Rez package of Kagezou, with a studio's own styles, presets and shortcuts beside it.

`rez-build --install` in this folder puts the program, all that it needs and the folder `studio` into the package; a
studio copies this file, and pins and splits as it does with others. `rez-env kagezou -- kagezou doctor` tries it.
A test keeps version and Python equal to those of the program.
"""

name = "kagezou"
version = "0.1.0"
description = "Cast-shadow layers for 2D animation, from the alpha of the character drawings"
authors = ["Kagezou contributors"]
requires = ["python-3.11+<3.15"]
tools = ["kagezou", "kagezou-window"]
build_command = "python {root}/build.py {install}"


def commands():
    """Put program and modules on the paths, and the studio's folders behind those of shows that come first."""
    env.PYTHONPATH.append("{root}/python")
    env.PATH.append("{root}/python/bin")
    env.KAGEZOU_STYLES.append("{root}/studio/styles")
    env.KAGEZOU_PRESETS.append("{root}/studio/presets")
    env.KAGEZOU_SHORTCUTS.append("{root}/studio/shortcuts")
