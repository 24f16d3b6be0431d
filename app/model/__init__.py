"""What is edited: frozen snapshots of the document, their history, the selection."""
