"""How fast the window answers a real hand: events of the X server, and the time until what they did is on screen.

It may use every room of the window; only whoever opens the window for measuring knows it.
It must never change what it measures.
"""
