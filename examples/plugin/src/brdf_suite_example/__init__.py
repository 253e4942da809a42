"""An example of a plug-in: a reflectance model and a palette format."""
