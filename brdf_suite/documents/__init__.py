"""User documents: frozen, validated, versioned values with atomic reading and writing.

Import from the modules: ``paint`` (the paint), ``view`` (camera and scene), ``store`` (files).
"""
