"""Projects and exports from the user's side, and what is remembered."""
