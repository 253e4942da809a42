"""Acquire…: from photographs of a painted sphere to a paint, step by step, in a window of its own.

``views`` draw arrays, ``*_page`` are the steps, ``work`` calls the core on threads, ``controller`` joins them.
"""
