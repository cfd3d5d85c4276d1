"""One module a verb, imported only when it is typed: ``add_arguments(parser)`` and ``run(options, entry_points)``.

They may use every room below the command line, and its own parser and terminal.
They must never know each other.
"""
