"""Projects: what the editor has open, and the files that keep it."""
