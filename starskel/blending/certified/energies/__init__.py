"""What moves frames towards those that are wanted, and keeps vertices off edges."""
