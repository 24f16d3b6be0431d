"""Kernels: what lies to the left of all edges of a ring, from where the ring is seen whole."""
