"""Meshes: glTF, OBJ, STL and PLY."""
