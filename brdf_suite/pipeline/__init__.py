"""The one road, composed once: paint to weights, environment to maps, scene to picture.

Import what is needed from the modules (``pipeline.material``, ``pipeline.lobe_fit``, ``pipeline.picture``): the package
itself loads none of them, so that a program that only fits a paint never waits for OpenGL or for
a mesh reader.
"""
