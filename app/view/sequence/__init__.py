"""The key shapes above the canvases."""
