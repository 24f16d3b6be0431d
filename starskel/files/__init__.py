"""What is read and written: one module a format."""
