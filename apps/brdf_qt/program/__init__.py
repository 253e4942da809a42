"""Start of a program: application, arguments, settings, theme, translation."""
