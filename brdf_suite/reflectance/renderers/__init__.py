"""The material models of other renderers, as those renderers evaluate them: for exports, their losses, and imports."""
