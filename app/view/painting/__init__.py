"""How things are painted: colours, cameras, icons, and what is drawn in several views."""
