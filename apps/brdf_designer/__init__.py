"""Designer: the program in which a paint is made."""
