"""The last resort: a convex combination morph of both shapes in one square, and what it takes to make one."""
