"""Models: sliders for the numbers of the selected one, and the text of one that is written here."""
