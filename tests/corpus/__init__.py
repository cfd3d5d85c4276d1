"""Small files of every kind that is read, and what is right to say of each."""
