"""How far the real-time picture is from the path-traced one."""
