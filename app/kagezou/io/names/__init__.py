"""Names of numbered things: which part of them runs, whatever stands around it; of files, layers and cels alike.

It may use the standard library and messages.
It must never know files, pictures or layers: names go in, numbers and runs come out.
"""
