"""What is read and written: one module a format; `projects` has those of the editor."""
