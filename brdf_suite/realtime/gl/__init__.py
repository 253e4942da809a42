"""OpenGL: context, objects, programs, meshes, targets."""
