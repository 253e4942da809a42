"""The description of a folder of photographs, and the check of the folder against it."""
