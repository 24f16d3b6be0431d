"""Convex pieces of one polygon carried over to the other, by paths that keep clear of it."""
