"""Blends out: what is to be drawn, whatever file it goes into, and one module for each format.

`settings` says what is wanted, `film` makes drawings of it, `animation` those of what moves. `formats`
finds the module by layout and ending, and `write` puts the files in place: so do both editor and command.
"""
