"""Blends of shapes in which no ring ever touches itself or another one."""
