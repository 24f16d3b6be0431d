"""What a canvas shows, painter by painter."""
