"""Files as such: written whole or not at all, read as strict JSON, and words for what a file system refuses.

It may use the standard library alone.
It must never know what a file holds.
"""
