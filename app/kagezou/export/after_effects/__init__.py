"""The hand-off to After Effects: footage in folders and one script that builds the composition."""
