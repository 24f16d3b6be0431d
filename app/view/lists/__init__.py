"""Marks, parts and edits as lists."""
