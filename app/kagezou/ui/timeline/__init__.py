"""The dope sheet: layers, exposures and keys over time."""
