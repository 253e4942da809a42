"""The one-page report of a paint as HTML and PDF."""
