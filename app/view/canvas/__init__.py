"""The two shapes, looked at and edited."""
