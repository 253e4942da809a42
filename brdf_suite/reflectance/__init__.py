"""Reflectances behind one ``eval``: models, clearcoats, construction from paints, virtual measurement."""
