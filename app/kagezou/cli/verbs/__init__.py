"""One module for each verb, imported only when it is typed: ``add_arguments(parser)`` and ``run(options, doors)``.

They may use every room below the command line, and its own parser and terminal.
They must never know each other.
"""
