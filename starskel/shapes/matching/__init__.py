"""From what is given of two shapes to which of their rings become which, row by row."""
