"""The verbs of the command, one module each: its `run` does what the words say."""
