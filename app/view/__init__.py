"""The window: everything that is painted and clicked."""
