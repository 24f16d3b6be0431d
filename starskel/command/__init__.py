"""What the command does: its words, its verbs, and what these share."""

FAILED = 2
"""The exit status where something was wrong with what was given."""
