"""What the command does: one module a verb."""

FAILED = 2
"""The exit status where something was wrong with what was given."""
