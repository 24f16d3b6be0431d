"""What menus, lists and fields of numbers do, without a pointer: each verb answers as a tool does."""
