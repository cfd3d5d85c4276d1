"""The curve editor: values and speeds of keyed properties over time, and what leads say about them."""
