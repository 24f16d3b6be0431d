"""Blend one drawn shape into another by the star-skeleton."""
