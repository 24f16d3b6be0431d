"""The editor: draw two shapes, mark what corresponds, watch and export the blends."""
