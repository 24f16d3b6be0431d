"""Shapes in: one module for each format of drawings and maps, found by the ending of the file's name.

Each gives named shapes, and says what it had to mend on the way in.
"""
