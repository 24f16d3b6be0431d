"""The options bar: what can be set for the tool in hand, page by page."""
