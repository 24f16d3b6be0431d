"""What pointer and keys do on a canvas: each tool is a state that answers an event with the next state."""
