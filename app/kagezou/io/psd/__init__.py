"""PSD and PSB files: their tree, their pixels, what of them is not drawn, and writing them.

It may use psd-tools (through `file` alone), numpy and the rooms of pixels and files.
It must never know documents, characters or exposures: what a layer means is said where files are imported.
"""
