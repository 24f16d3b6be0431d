"""Sheets of keyframes: how they are laid out, whatever file they go into."""
