"""Blends that provably never cross themselves."""
