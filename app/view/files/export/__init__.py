"""Exporting from the user's side: the dialog, its fields, and what is written then."""
