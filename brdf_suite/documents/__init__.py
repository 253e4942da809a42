"""What a user saves: frozen, validated, versioned values and their atomic reading and writing.

Import from the modules: ``paint`` (the paint), ``view`` (camera and scene), ``store`` (files).
"""
