"""What keeps unsaved work through a crash: copies in the state folder, and what finds them again."""
