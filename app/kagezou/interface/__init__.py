"""The program for scripts: cuts as values that are opened, changed, drawn and exported; what `import kagezou` gives.

It may use every room below it, and an OpenGL context that it is handed. What is public here keeps its word from version
to version. It must never know Qt, a terminal, nor keep anything that is not in a value.
"""
