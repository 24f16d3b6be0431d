"""The clock: playing, the slider, the chart over t, and the easing."""
