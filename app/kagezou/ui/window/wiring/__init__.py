"""What happens in one part of the window when something happens in another: every connection is made here.

It may use the parts of the window that it is handed, and nothing of `MainWindow`.
It must never hold state of its own.
"""
