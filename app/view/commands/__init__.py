"""The one table of commands, and the menus, toolbar, finder and shortcuts made from it."""
